// Prints what the gases' tests measure, from runs about ten times as long: theory, measured value,
// its standard error over seeds. Some minutes.
#include <fmt/format.h>

#include <array>
#include <string_view>

#include "support/gas_measures.h"
#include "support/gas_theory.h"

namespace wells {
namespace {

void row(std::string_view quantity, double theory, const Sample& measured) {
  fmt::print("{:<46} {:>10.6f} {:>10.6f} {:>+9.2f} {:>9.2f} {:>6}\n", quantity, theory,
             measured.mean(), 100 * (measured.mean() / theory - 1),
             100 * measured.standardError() / theory, measured.values.size());
}

void printFluids() {
  const auto fluid = [](double eta, int settling, std::string_view name) {
    const double density = eta / theory::packing(1);
    const FluidSamples samples =
        measureFluid({.density = density, .settling = settling, .hits = 400'000, .seeds = 10});
    row(fmt::format("pressure, {} (Carnahan-Starling)", name),
        density * theory::carnahanStarling(eta), samples.pressure);
    row(fmt::format("free time, {} (Enskog)", name), 1 / theory::hitRate(density),
        samples.freeTime);
  };
  fluid(0.25, 20, "eta 0.25");
  fluid(theory::packing(0.5), 20, "n 0.5");
  fluid(0.45, 60, "eta 0.45");
}

void printCooling() {
  constexpr std::array kHitsPerBall = {1, 5, 10, 15, 20, 25, 30};
  const std::vector<Sample> ratios =
      measureCooling(0.1 / theory::packing(1), 0.9, 864, 160, kHitsPerBall);
  for (std::size_t k = 0; k < ratios.size(); ++k)
    row(fmt::format("cooling, {} hits a ball: T / T of Haff's law", kHitsPerBall[k]), 1, ratios[k]);
}

void printFlatGas() {
  Sample plain, steady;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const FlatGas gas = measureFlatGas(seed, 120, 2000);
    plain.values.push_back(gas.compressibility);
    steady.values.push_back(gas.steady);
  }
  const double expected = theory::henderson(4000 * 0.25 / (79.5 * 79.5));
  row("wall pressure, flat gas (Henderson)", expected, plain);
  row("the same without the sloshing", expected, steady);
}

}  // namespace
}  // namespace wells

int main() {
  fmt::print("{:<46} {:>10} {:>10} {:>9} {:>9} {:>6}\n", "", "theory", "measured", "off by, %",
             "+-, %", "seeds");
  wells::printFluids();
  wells::printCooling();
  wells::printFlatGas();
}
