#include <shell_origami/base/files.h>

#include <shell_origami/base/error.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

namespace shell_origami {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failToWrite(const std::string& path, const std::string& reason) {
  throw std::runtime_error("cannot write " + path + ": " + reason);
}

/// Writes the whole text to the disk. Returns 0 or errno.
int writeWhole(const std::string& path, const std::string& text) {
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return errno;
  int error = 0;
  if (std::fwrite(text.data(), 1, text.size(), file) != text.size()) error = errno;
  if (error == 0 && std::fflush(file) != 0) error = errno;
  if (error == 0 && fsync(fileno(file)) != 0 && errno != EINVAL) error = errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  return error;
}

/// Brings the names in a folder to the disk. Some file systems cannot; their renames hold without.
void syncFolder(const std::string& folder) {
  const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

/// The path that symbolic links lead to, whether or not there is a file.
std::string followLinks(const std::string& path) {
  constexpr int kMostLinks = 40;  // as Linux has it
  fs::path target = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target)); ++links) {
    if (links == kMostLinks) failToWrite(path, "its symbolic links form a loop");
    const fs::path next = fs::read_symlink(target);
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target.string();
}

/// A file beside its target, removed unless it is renamed to it.
class PartFile {
 public:
  explicit PartFile(const TextFile& file) {
    try {
      target_ = followLinks(file.path);
    } catch (const fs::filesystem_error& error) {
      failToWrite(file.path, error.code().message());
    }
    std::error_code ignored;
    const fs::file_status status = fs::status(target_, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
      failToWrite(file.path, "it is not a regular file");
    }
    part_ = target_ + "." + std::to_string(getpid()) + ".part";
    const int error = writeWhole(part_, file.text);
    if (error == 0) return;
    std::remove(part_.c_str());
    failToWrite(file.path, std::strerror(error));
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile() { std::remove(part_.c_str()); }  // gone already where it was renamed

  std::pair<std::string, std::string> move() const { return {part_, target_}; }

 private:
  std::string target_, part_;
};

/// The older file of a target while others are being renamed, kept under a second name.
class OldFile {
 public:
  explicit OldFile(std::string target) : target_(std::move(target)) {
    std::error_code ignored;
    const fs::file_status status = fs::status(target_, ignored);
    if (!fs::exists(status)) return;
    if (!fs::is_regular_file(status)) failToWrite(target_, "it is not a regular file");
    kept_ = target_ + "." + std::to_string(getpid()) + ".old";
    std::remove(kept_.c_str());
    // On a file system without hard links the older file is moved away for a moment.
    if (link(target_.c_str(), kept_.c_str()) == 0) return;
    if (std::rename(target_.c_str(), kept_.c_str()) != 0) {
      kept_.clear();
      failToWrite(target_, std::strerror(errno));
    }
  }

  void putBack() const {
    if (kept_.empty()) {
      std::remove(target_.c_str());
      return;
    }
    std::rename(kept_.c_str(), target_.c_str());
    forget();  // two names of one file stay where one is renamed to the other
  }
  void forget() const {
    if (!kept_.empty()) std::remove(kept_.c_str());
  }

 private:
  std::string target_, kept_;
};

}  // namespace

std::string expandedPath(const std::string& path) {
  const bool is_home = path == "~" || path.rfind("~/", 0) == 0;
  const char* home = is_home ? std::getenv("HOME") : nullptr;
  return home ? home + path.substr(1) : path;
}

std::string readFile(const std::string& path, std::uintmax_t most_bytes) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status)) reject("cannot be read: there is no such file");
  if (fs::is_directory(status)) reject("cannot be read: it is a folder");
  // A pipe may never deliver anything, and /dev/zero never ends.
  if (!fs::is_regular_file(status)) reject("cannot be read: it is not a regular file");
  const std::uintmax_t size = fs::file_size(path, ignored);
  if (size > most_bytes && !ignored) {
    reject("cannot be read: it has ", size, " bytes, more than the ", most_bytes, " allowed");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file.good() && !file.eof()) {
    reject("cannot be read: ", errno != 0 ? std::strerror(errno) : "unknown reason");
  }
  return text;
}

void writeFiles(const std::vector<TextFile>& files) {
  std::deque<PartFile> parts;
  std::vector<std::pair<std::string, std::string>> moves;
  for (const TextFile& file : files) {
    parts.emplace_back(file);
    moves.push_back(parts.back().move());
  }
  renameTogether(moves);
}

void renameTogether(const std::vector<std::pair<std::string, std::string>>& moves) {
  std::vector<OldFile> replaced;
  std::set<std::string> folders;
  try {
    for (const auto& [from, to] : moves) {
      // The last one needs no way back.
      if (replaced.size() + 1 < moves.size()) replaced.emplace_back(to);
      if (std::rename(from.c_str(), to.c_str()) != 0) failToWrite(to, std::strerror(errno));
      folders.insert(fs::path(to).parent_path().string());
    }
  } catch (const std::runtime_error&) {
    for (auto old = replaced.rbegin(); old != replaced.rend(); ++old) old->putBack();
    throw;
  }
  for (const std::string& folder : folders) syncFolder(folder);
  for (const OldFile& old : replaced) old.forget();
}

}  // namespace shell_origami
