#include "network/message_fields.h"

namespace wells {
namespace {

Vec3 vectorOf(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}

void write(const Vec3& from, double (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

}  // namespace

Generation generationOf(const gravity_wells::peer_header_t& header) {
  return {header.generation_resets, header.generation_founded, header.generation_nonce};
}

Version versionOf(const gravity_wells::peer_header_t& header,
                  const gravity_wells::ball_state_t& ball, const Incarnation& owner,
                  std::int64_t step) {
  return {.generation = generationOf(header),
          .term = ball.term,
          .adopter = {PeerId{ball.adopter}, ball.adopter_incarnation},
          .epoch = ball.epoch,
          .owner = owner,
          .step = step};
}

BallState stateOf(const gravity_wells::ball_state_t& ball) {
  return {vectorOf(ball.position), vectorOf(ball.velocity), vectorOf(ball.spin)};
}

gravity_wells::ball_state_t ballMessage(std::size_t ball, const Version& version,
                                        const BallState& state) {
  gravity_wells::ball_state_t message;
  message.id = static_cast<std::int32_t>(ball);
  message.term = version.term;
  message.adopter = value(version.adopter.peer);
  message.adopter_incarnation = version.adopter.number;
  message.epoch = version.epoch;
  write(state.position, message.position);
  write(state.velocity, message.velocity);
  write(state.spin, message.spin);
  return message;
}

}  // namespace wells
