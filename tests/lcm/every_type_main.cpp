// Writes, publishes or awaits one message of every type of ours.
//   every_type log FILE         into an LCM log
//   every_type publish SECONDS  on LCM_DEFAULT_URL, all of them ten times a second
//   every_type await SECONDS    on LCM_DEFAULT_URL; exit status 0 when each has come, byte for byte
#include <lcm/lcm.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

#include "lcm/every_type.h"

namespace {

using wells::channelOf;
using wells::EncodedMessages;

int writeLog(const char* path) {
  lcm_eventlog_t* log = lcm_eventlog_create(path, "w");
  if (!log) return 1;
  std::int64_t time = 0;  // us
  for (auto& [type, bytes] : wells::encodeEveryType()) {
    std::string channel = channelOf(type);
    lcm_eventlog_event_t event{};
    event.timestamp = ++time;
    event.channellen = static_cast<std::int32_t>(channel.size());
    event.datalen = static_cast<std::int32_t>(bytes.size());
    event.channel = channel.data();
    event.data = const_cast<std::uint8_t*>(bytes.data());
    if (lcm_eventlog_write_event(log, &event) != 0) return 1;
  }
  lcm_eventlog_destroy(log);
  return 0;
}

int publish(lcm_t* lcm, double seconds) {
  for (int tick = 0; tick < seconds * 10; ++tick) {
    for (const auto& [type, bytes] : wells::encodeEveryType()) {
      lcm_publish(lcm, channelOf(type).c_str(), bytes.data(), static_cast<unsigned>(bytes.size()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return 0;
}

void forget(const lcm_recv_buf_t* message, const char* channel, void* missing) {
  const auto* data = static_cast<const std::uint8_t*>(message->data);
  std::erase_if(*static_cast<EncodedMessages*>(missing), [&](const auto& expected) {
    const auto& [type, bytes] = expected;
    return channelOf(type) == channel &&
           std::equal(bytes.begin(), bytes.end(), data, data + message->data_size);
  });
}

int await(lcm_t* lcm, double seconds) {
  using Clock = std::chrono::steady_clock;
  EncodedMessages missing = wells::encodeEveryType();
  lcm_subscribe(lcm, "WELLS_TEST_.*", forget, &missing);
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (!missing.empty() && Clock::now() < end) lcm_handle_timeout(lcm, 100);
  for (const auto& [type, bytes] : missing) std::printf("%s has not come\n", type.c_str());
  return missing.empty() ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  const std::string mode = count == 3 ? arguments[1] : "";
  if (mode == "log") return writeLog(arguments[2]);
  if (mode != "publish" && mode != "await") {
    std::puts("usage: every_type log FILE | publish SECONDS | await SECONDS");
    return 2;
  }
  lcm_t* lcm = lcm_create(nullptr);
  if (!lcm) return 1;
  const double seconds = std::stod(arguments[2]);
  const int status = mode == "publish" ? publish(lcm, seconds) : await(lcm, seconds);
  lcm_destroy(lcm);
  return status;
}
