#include <shell_origami/base/files.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace shell_origami {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  Files() : folder_(testing::TempDir() + "files_test." + std::to_string(getpid())) {
    fs::create_directory(folder_);
  }
  ~Files() override { fs::remove_all(folder_); }

  std::string in(const std::string& name) const { return folder_ + "/" + name; }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(in(name)) << text;
  }
  std::string contents(const std::string& name) const { return readFile(in(name), 1000); }
  std::size_t count() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

 private:
  std::string folder_;
};

TEST_F(Files, aRenameThatFailsGivesEveryEarlierFileBack) {
  put("a", "old a");
  put("a.part", "new a");
  put("b.part", "new b");
  put("c.part", "new c");
  fs::create_directory(in("c"));
  EXPECT_THROW(
      renameTogether({{in("a.part"), in("a")}, {in("b.part"), in("b")}, {in("c.part"), in("c")}}),
      std::runtime_error);
  EXPECT_EQ(contents("a"), "old a");
  EXPECT_FALSE(fs::exists(in("b")));
  EXPECT_TRUE(fs::is_directory(in("c")));
}

TEST_F(Files, aFileThatIsMissingLeavesItsTarget) {
  put("a", "old a");
  put("b", "old b");
  put("b.part", "new b");
  EXPECT_THROW(renameTogether({{in("nowhere"), in("a")}, {in("b.part"), in("b")}}),
               std::runtime_error);
  EXPECT_EQ(contents("a"), "old a");
  EXPECT_EQ(contents("b"), "old b");
  EXPECT_EQ(count(), 3u);  // a, b, b.part
}

TEST_F(Files, writesAllAndLeavesNothingBeside) {
  put("a", "old a");
  writeFiles({{in("a"), "new a"}, {in("b"), "new b"}});
  writeFiles({{in("a"), "newer a"}, {in("b"), "newer b"}});
  EXPECT_EQ(contents("a"), "newer a");
  EXPECT_EQ(contents("b"), "newer b");
  EXPECT_EQ(count(), 2u);
}

TEST_F(Files, aLinkStaysALinkWhetherOrNotItsTargetExists) {
  fs::create_symlink("target", in("link"));
  fs::create_symlink(in("link"), in("second"));
  writeFiles({{in("second"), "first text"}});
  EXPECT_EQ(contents("target"), "first text");
  writeFiles({{in("second"), "second text"}});
  EXPECT_EQ(contents("target"), "second text");
  EXPECT_TRUE(fs::is_symlink(in("link")));
  EXPECT_TRUE(fs::is_symlink(in("second")));
  EXPECT_EQ(count(), 3u);
}

TEST_F(Files, aLoopOfLinksIsRejected) {
  fs::create_symlink("two", in("one"));
  fs::create_symlink("one", in("two"));
  EXPECT_THROW(writeFiles({{in("one"), ""}}), std::runtime_error);
}

TEST_F(Files, readsNoMoreThanAllowed) {
  put("ten", "0123456789");
  EXPECT_EQ(readFile(in("ten"), 10), "0123456789");
  try {
    readFile(in("ten"), 9);
    FAIL() << "it was read";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "cannot be read: it has 10 bytes, more than the 9 allowed");
  }
}

TEST_F(Files, expandsTheHomeFolder) {
  const char* home = std::getenv("HOME");
  const std::string before = home ? home : "";
  setenv("HOME", "/home/somebody", 1);
  EXPECT_EQ(expandedPath("~"), "/home/somebody");
  EXPECT_EQ(expandedPath("~/papers/crane.fold"), "/home/somebody/papers/crane.fold");
  EXPECT_EQ(expandedPath("papers/~/crane.fold"), "papers/~/crane.fold");
  EXPECT_EQ(expandedPath("~other/crane.fold"), "~other/crane.fold");
  EXPECT_EQ(expandedPath(""), "");
  unsetenv("HOME");
  EXPECT_EQ(expandedPath("~/x"), "~/x");
  if (home) setenv("HOME", before.c_str(), 1);
}

}  // namespace
}  // namespace shell_origami
