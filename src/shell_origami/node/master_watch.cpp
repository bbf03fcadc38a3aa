#include <shell_origami/node/master_watch.h>

#include <ros/master.h>
#include <ros/network.h>
#include <ros/param.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcException.h>

namespace shell_origami {
namespace {

using XmlRpc::XmlRpcValue;

constexpr std::chrono::seconds kPeriod(1);
constexpr double kMasterWarnPeriod = 60;  ///< [s]

/// A call of the master API or, at another place, of a node's (wiki.ros.org/ROS/Master_API,
/// ROS/Slave_API) in this node's name. Nothing where nobody answers.
template <class... Arguments>
std::optional<XmlRpcValue> call(const std::string& method, const Arguments&... arguments) {
  XmlRpcValue request, response, payload;
  int i = 0;
  request[i++] = ros::this_node::getName();
  ((request[i++] = arguments), ...);
  if (!ros::master::execute(method, request, response, payload, false)) return std::nullopt;
  return payload;
}

std::string ownUri() { return ros::XMLRPCManager::instance()->getServerURI(); }

/// The names of a list of [name, [nodes]] in which this node is.
std::set<std::string> namesWithThisNode(XmlRpcValue& entries) {
  std::set<std::string> names;
  for (int i = 0; i < entries.size(); ++i) {
    XmlRpcValue& nodes = entries[i][1];
    for (int k = 0; k < nodes.size(); ++k) {
      if (std::string(nodes[k]) == ros::this_node::getName()) names.insert(entries[i][0]);
    }
  }
  return names;
}

/// Tells this node, in the place of a new master, who publishes a topic: that master tells only
/// those that register with it.
void tellPublishers(const std::string& topic, const XmlRpcValue& publishers) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(ownUri(), host, port)) return;
  XmlRpcValue request, response;
  request[0] = "/master";
  request[1] = topic;
  request[2] = publishers;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  client.execute("publisherUpdate", request, response);
}

}  // namespace

MasterWatch::MasterWatch() : thread_([this] { run(); }) {}

MasterWatch::~MasterWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    end_ = true;
  }
  ending_.notify_all();
  thread_.join();
}

bool MasterWatch::endsWithin(std::chrono::seconds period) {
  std::unique_lock<std::mutex> lock(mutex_);
  return ending_.wait_for(lock, period, [this] { return end_; });
}

void MasterWatch::run() {
  while (!endsWithin(kPeriod)) {
    try {
      look();
    } catch (const XmlRpc::XmlRpcException& error) {
      ROS_WARN_THROTTLE(kMasterWarnPeriod, "the master's answer is invalid: %s",
                        error.getMessage().c_str());
    }
  }
}

void MasterWatch::look() {
  std::optional<XmlRpcValue> pid = call("getPid");
  if (!pid) return;
  if (pid_ && *pid_ != static_cast<int>(*pid)) {
    registerAgain();
    ROS_WARN("another master has taken the place of the one before: the node is registered there");
  }
  pid_ = static_cast<int>(*pid);
  remember();
}

void MasterWatch::remember() {
  std::optional<XmlRpcValue> state = call("getSystemState"), types = call("getTopicTypes");
  if (!state || !types) return;
  const std::set<std::string> publications = namesWithThisNode((*state)[0]);
  if (publications.empty()) return;  // the master is on its way out
  publications_ = publications;
  subscriptions_ = namesWithThisNode((*state)[1]);
  services_ = namesWithThisNode((*state)[2]);
  for (int i = 0; i < types->size(); ++i) types_[(*types)[i][0]] = std::string((*types)[i][1]);
  if (!service_uri_.empty() || services_.empty()) return;
  std::optional<XmlRpcValue> uri = call("lookupService", *services_.begin());
  if (uri) service_uri_ = std::string(*uri);
}

void MasterWatch::registerAgain() const {
  const auto type_of = [this](const std::string& topic) {
    const auto type = types_.find(topic);
    return type == types_.end() ? std::string("*") : type->second;
  };
  if (ros::Time::isSimTime()) ros::param::set("/use_sim_time", true);
  for (const std::string& topic : publications_) {
    call("registerPublisher", topic, type_of(topic), ownUri());
  }
  for (const std::string& service : services_) {
    call("registerService", service, service_uri_, ownUri());
  }
  for (const std::string& topic : subscriptions_) {
    const auto publishers = call("registerSubscriber", topic, type_of(topic), ownUri());
    if (publishers) tellPublishers(topic, *publishers);
  }
}

}  // namespace shell_origami
