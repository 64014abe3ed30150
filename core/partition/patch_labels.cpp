// Labels are renumbered by a table of new names.
#include "partition/patch_labels.h"

#include <numeric>

namespace vorogeo {

Index compact(std::vector<Index>& label, std::span<const Index> faces, Index labels) {
  std::vector<Index> renamed(labels, no_index);
  for (Index f : faces) renamed[label[f]] = 0;
  Index used = 0;
  for (Index& name : renamed) {
    if (name != no_index) name = used++;
  }
  for (Index f : faces) label[f] = renamed[label[f]];
  return used;
}

void join_into_one_patch(std::span<const std::uint8_t> mask, Partition& partition) {
  const Index first = partition.first_layer_count, second = partition.second_layer_count;
  std::vector<Index> faces(mask.size());
  std::iota(faces.begin(), faces.end(), 0);
  for (Index f : faces) {
    if (mask[f] == 0) continue;
    partition.first_layer[f] = first;
    partition.second_layer[f] = second;
  }
  partition.first_layer_count = compact(partition.first_layer, faces, first + 1);
  partition.second_layer_count = compact(partition.second_layer, faces, second + 1);
  partition.parent.assign(partition.second_layer_count, 0);
  for (Index f : faces) partition.parent[partition.second_layer[f]] = partition.first_layer[f];
}

}  // namespace vorogeo
