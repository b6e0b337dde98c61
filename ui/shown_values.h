#pragma once

#include "ui/edit_points.h"
#include "ui/settings.h"

namespace crest {

/// The TF in the values that the person sees: of the volume, or from 0 to 1, as the settings say. What comes
/// of the conversion is rounded far below what can be seen and below the distances of its points, to be
/// short.
TransferFunction shown_values(const TransferFunction& stored, Domain shown, ValueRange volume);

/// An edit of shown_values(stored) in the domain of `stored`. What the edit left alone stays as it was, to
/// the bit.
TransferFunction stored_values(const TransferFunction& edited, const TransferFunction& stored,
                               ValueRange volume);

/// In which the editor shows a TF: without a volume its own.
constexpr Domain shown_domain(const TransferFunction& tf, const StudioSettings& settings, bool has_volume) {
  return !has_volume ? tf.domain : settings.data_values ? Domain::data : Domain::normalized;
}

/// A TF, and what shown_values() makes of it: kept from frame to frame, since most of them change nothing.
struct ShownCurve {
  TransferFunction stored, shown;
  ValueRange volume;
};

/// Lets `edit` change the TF in shown values; `volume` is null where there is none. Returns what it does:
/// whether something changed. `kept` is what an earlier call left there: of the same TF nothing is converted.
template <class Edit>
bool edit_shown(TransferFunction& tf, const StudioSettings& settings, const ValueRange* volume,
                ShownCurve& kept, Edit&& edit) {
  const Domain domain = shown_domain(tf, settings, volume != nullptr);
  if (domain == tf.domain) return edit();
  if (kept.shown.domain != domain || kept.volume != *volume || kept.stored != tf)
    kept = {tf, shown_values(tf, domain, *volume), *volume};
  tf = kept.shown;
  const bool changed = edit();
  tf = tf == kept.shown ? kept.stored : stored_values(tf, kept.stored, *volume);
  return changed;
}

}  // namespace crest
