#include <shell_origami/node/message_text.h>

#include <algorithm>
#include <cctype>

namespace shell_origami {
namespace {

constexpr std::size_t kLongestText = 1000;  ///< [bytes]

/// Whether a letter of UTF-8 begins at this byte.
bool beginsLetter(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }

}  // namespace

std::string asMessageText(const std::string& text) {
  std::string sentence = text;
  if (text.size() > kLongestText) {
    std::size_t head = kLongestText / 2, tail = text.size() - kLongestText / 2;
    while (head > 0 && !beginsLetter(text[head])) --head;
    while (tail < text.size() && !beginsLetter(text[tail])) ++tail;
    sentence = text.substr(0, head) + "..." + text.substr(tail);
  }
  std::replace_if(
      sentence.begin(), sentence.end(),
      [](char byte) { return std::iscntrl(static_cast<unsigned char>(byte)); }, ' ');
  return sentence;
}

}  // namespace shell_origami
