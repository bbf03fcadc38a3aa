#include <shell_origami/base/bounded_json.h>

#include <shell_origami/base/error.h>

#include <algorithm>

namespace shell_origami {
namespace {

using Json = nlohmann::json;

[[noreturn]] void rejectDepth() {
  reject("its lists and objects nest deeper than ", kDeepestJson, " levels");
}

/// Walks over the items of a CBOR text in the order in which nlohmann's recursive reader does, but
/// with a stack of its own.
class CborWalk {
 public:
  explicit CborWalk(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  /// Throws std::invalid_argument if the items nest too deep or are of a kind whose length is not
  /// stated in advance. Stops where the bytes end; that they end too early is the reader's to say.
  void run() {
    items_left_ = {1};
    while (at_ < bytes_.size() && !items_left_.empty()) {
      if (items_left_.back() == 0) {
        items_left_.pop_back();
        continue;
      }
      --items_left_.back();
      readItem();
    }
  }

 private:
  void readItem() {
    const int kind = bytes_[at_] >> 5, size = bytes_[at_] & 31;
    ++at_;
    if (size == 31) reject("it holds a CBOR item of indefinite length");
    const std::uint64_t argument = readArgument(size);
    switch (kind) {
      case 2:
      case 3: at_ += std::min<std::uint64_t>(argument, bytes_.size() - at_); break;
      case 4: enter(argument); break;
      case 5: enter(2 * std::min(argument, kMostItems)); break;
      case 6: reject("it holds a CBOR tag");
      default: break;
    }
  }

  std::uint64_t readArgument(int size) {
    if (size < 24) return static_cast<std::uint64_t>(size);
    std::uint64_t value = 0;
    for (int left = 1 << (size - 24); left > 0 && at_ < bytes_.size(); --left) {
      value = value << 8 | bytes_[at_++];
    }
    return value;
  }

  void enter(std::uint64_t items) {
    if (static_cast<int>(items_left_.size()) > kDeepestJson) rejectDepth();
    items_left_.push_back(items);
  }

  static constexpr std::uint64_t kMostItems = std::uint64_t{1} << 62;

  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;
  std::vector<std::uint64_t> items_left_;  ///< of each list or map around, the innermost last
};

}  // namespace

Json parseJson(const std::string& text) {
  const auto check_depth = [](int depth, Json::parse_event_t event, const Json&) {
    const bool opens =
        event == Json::parse_event_t::array_start || event == Json::parse_event_t::object_start;
    if (opens && depth >= kDeepestJson) rejectDepth();
    return true;
  };
  try {
    return Json::parse(text, check_depth);
  } catch (const Json::parse_error& error) {
    const std::size_t byte = std::min<std::size_t>(error.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + byte, '\n');
    reject("is not JSON from line ", line, " (byte ", error.byte, ") on");
  } catch (const Json::exception&) {
    reject("is not JSON that can be read: a number is out of range");
  }
}

Json parseCbor(const std::vector<std::uint8_t>& bytes) {
  CborWalk(bytes).run();
  try {
    return Json::from_cbor(bytes);
  } catch (const Json::exception& error) {
    reject("it is not CBOR: ", error.what());
  }
}

std::string describeJson(const Json& value) {
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  if (value.is_object()) return "an object of " + std::to_string(value.size()) + " entries";
  if (value.is_binary()) return "bytes";
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

}  // namespace shell_origami
