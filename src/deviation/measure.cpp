#include "deviation/pairing.h"
#include "deviation/thorough.h"
#include "unstep/deviation.h"

namespace unstep {

Result<Deviation> measure_deviation(const Drawing& chains,
                                    const Drawing& paths) {
  using namespace deviation;
  if (Status valid = check_pairs(chains, paths); !valid) return valid.error();
  Deviation worst;
  for (std::size_t i = 0; i < paths.paths.size(); ++i) {
    const Chain& chain = chains.chains[i];
    const Measured found =
        thorough_measure(chain, paths.paths[i], chains.canvas.y_axis,
                         paths.scale, worst.distance);
    if (i > 0 && found.distance <= worst.distance) continue;
    worst = {found.distance, i, found.step,
             static_cast<double>(chain.origin.x + found.place.x),
             static_cast<double>(chain.origin.y + found.place.y)};
  }
  return worst;
}

}  // namespace unstep
