#include "program.h"

namespace crest::test {
namespace {

/// Machines without a graphics driver: EGL is told of no vendor, or cannot be loaded.
class NoDriver : public ProgramTest, public testing::WithParamInterface<bool> {
 protected:
  NoDriver() {
    const std::string unloadable = write("libEGL.so.1", "no library");
    prefix_ = GetParam() ? "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent"
                         : "LD_LIBRARY_PATH=" + unloadable.substr(0, unloadable.rfind('/'));
  }
  std::string prefix_;
};

TEST_P(NoDriver, IsAnErrorOfOneLine) {
  for (const std::string command : {"render", "compare"})
    expect_error(1, {command, "builtin:sphere?n=8", "--size", "8x8", "-o", path("a.png")},
                 {"no graphics driver", "OpenGL 4.5"}, "export " + prefix_ + ";");
  expect_error(1, {"render", "builtin:sphere?n=8", "--size", "8x8", "-o", path("a.png"), "--device", "0"},
               {"--device 0", "0 graphics devices"}, "export " + prefix_ + ";");
}

TEST_P(NoDriver, NoDevicesAreNone) {
  const Outcome outcome = run({"list", "devices"}, "export " + prefix_ + ";");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "none\n");
  EXPECT_EQ(outcome.err, "");
}

INSTANTIATE_TEST_SUITE_P(Machines, NoDriver, testing::Values(true, false),
                         [](const auto& param) { return param.param ? "WithoutADriver" : "WithoutEgl"; });

}  // namespace
}  // namespace crest::test
