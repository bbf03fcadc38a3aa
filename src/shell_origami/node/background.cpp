#include <shell_origami/node/background.h>

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <boost/make_shared.hpp>

#include <utility>

namespace shell_origami {
namespace {

class Call : public ros::CallbackInterface {
 public:
  explicit Call(std::function<void()> function) : function_(std::move(function)) {}
  CallResult call() override {
    function_();
    return Success;
  }

 private:
  std::function<void()> function_;
};

}  // namespace

void callInNodeThread(std::function<void()> function) {
  ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<Call>(std::move(function)));
}

Background::Background(std::function<void(const Cancelled&)> work)
    : thread_([this, work = std::move(work)] {
        try {
          work(cancelled_);
        } catch (...) {
          error_ = std::current_exception();
        }
        done_ = true;
        callInNodeThread([] {});
      }) {}

Background::~Background() {
  cancel();
  thread_.join();
}

}  // namespace shell_origami
