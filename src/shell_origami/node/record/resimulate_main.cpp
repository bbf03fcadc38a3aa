/// \file
/// Simulates a recorded run again, from the bag alone:
///
///     rosrun shell_origami resimulate RUN.bag
///
/// Exit codes, as those of diff: 0 every state came out the same to the bit, 1 some did not (the
/// largest difference is printed), 2 it cannot be simulated again (why is printed).

#include <shell_origami/node/record/resimulation.h>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using shell_origami::Resimulation;
namespace msg = shell_origami::msg;

template <class Message>
void add(const rosbag::MessageInstance& message, Resimulation& resimulation) {
  if (message.getDataType() != ros::message_traits::DataType<Message>::value()) return;
  const auto read = message.instantiate<Message>();
  if (!read) {
    throw std::invalid_argument(message.getDataType() +
                                " was recorded by another version of shell_origami");
  }
  resimulation.add(read);
}

/// Topics are known by what they carry: the node may have had another name.
Resimulation::Result simulate(const std::string& path) {
  rosbag::Bag bag(path, rosbag::bagmode::Read);
  const std::vector<std::string> names = {ros::message_traits::DataType<msg::Edit>::value(),
                                          ros::message_traits::DataType<msg::SheetState>::value()};
  const rosbag::TypeQuery types(names);
  Resimulation resimulation;
  for (const rosbag::MessageInstance& message : rosbag::View(bag, types)) {
    add<msg::Edit>(message, resimulation);
    add<msg::SheetState>(message, resimulation);
  }
  return resimulation.finish();
}

int tell(const std::string& path, const Resimulation::Result& result) {
  std::printf("%s: %zu states over %.3f s and %zu edits simulated again: ", path.c_str(),
              result.states, result.duration, result.edits);
  if (result.different == 0) {
    std::printf("the same to the bit\n");
  } else {
    std::printf("%zu differ, from %.3f s on, by %g m at most\n", result.different, result.first,
                result.largest);
  }
  if (result.skipped > 0) {
    std::printf("%zu states were recorded before the whole paper\n", result.skipped);
  }
  return result.different == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: resimulate RUN.bag\n");
    return 2;
  }
  try {
    return tell(argv[1], simulate(argv[1]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "resimulate: %s: %s\n", argv[1], error.what());
    return 2;
  }
}
