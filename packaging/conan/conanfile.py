"""The Conan recipe of the C++ library."""

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, rmdir

required_conan_version = ">=2.0"


class Vorogeo(ConanFile):
    """Static by default; nothing is needed beside a compiler of GCC's kind with C++20."""

    name = "vorogeo"
    version = "@VERSION@"
    description = "Geodesic distances and shortest paths on triangle meshes"
    license = "GPL-3.0-or-later"
    topics = ("geodesic", "triangle-mesh", "shortest-path", "geometry")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False]}  # noqa: RUF012
    default_options = {"shared": False, "fPIC": True}  # noqa: RUF012
    implements = ["auto_shared_fpic"]  # noqa: RUF012

    def layout(self):
        """Sources and builds in folders of their own."""
        cmake_layout(self, src_folder="src")

    def validate(self):
        """Refuse what cannot compile it."""
        check_min_cppstd(self, 20)

    def source(self):
        """Unpack the source archive."""
        get(self, "@URL@", sha256="@SHA256@", strip_root=True)

    def generate(self):
        """Hand the profile to CMake."""
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["VOROGEO_WARNINGS_AS_ERRORS"] = False
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        """Compile the library."""
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="vorogeo")

    def package(self):
        """Install it; how others find it is written by Conan."""
        CMake(self).install()
        copy(self, "LICENSE", src=self.source_folder, dst=f"{self.package_folder}/licenses")
        for folder in ("lib/cmake", "lib/pkgconfig", "share"):
            rmdir(self, f"{self.package_folder}/{folder}")

    def package_info(self):
        """What users link."""
        self.cpp_info.libs = ["vorogeo"]
        if self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.system_libs = ["m", "pthread"]
