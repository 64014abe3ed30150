// Sums of rent, compared with a price.
#include "query/rent_or_buy.h"

#include <algorithm>
#include <limits>

namespace vorogeo {

void RentOrBuy::pay(double seconds) {
  rent_ += std::max(0.0, seconds);
  ++answers_;
}

void RentOrBuy::set_price(double seconds) {
  price_ = seconds;
  has_price_ = true;
}

void RentOrBuy::give_up() { set_price(std::numeric_limits<double>::infinity()); }

}  // namespace vorogeo
