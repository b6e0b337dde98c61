#include "app/last_volume.h"

#include "ui/edit_points.h"

namespace crest {

TransferFunction LastVolume::carried_to(ValueRange to, const VolumeValues* values, CarryBy by,
                                        Domain domain) const {
  const bool is_known = distribution && values;
  const TransferFunction data = carried(tf, is_known ? *distribution : ValueDistribution{range, {}, {}},
                                        is_known ? values->distribution : ValueDistribution{to, {}, {}}, by);
  return in_domain(data, domain, to);
}

LastVolume last_volume(const Volume& volume, const std::string& source, const TransferFunction& tf,
                       const VolumeValues* values) {
  const ValueRange range = volume.statistics.range;
  LastVolume last{volume.name, in_domain(tf, Domain::data, range), range, source, volume.grid.dims, {}};
  if (values) last.distribution = values->distribution;
  return last;
}

}  // namespace crest
