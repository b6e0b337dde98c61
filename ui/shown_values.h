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

/// Lets `edit` change the TF in shown values; `volume` is null where there is none. Returns what it does:
/// whether something changed.
template <class Edit>
bool edit_shown(TransferFunction& tf, const StudioSettings& settings, const ValueRange* volume, Edit&& edit) {
  const Domain shown = shown_domain(tf, settings, volume != nullptr);
  if (shown == tf.domain) return edit();
  const TransferFunction stored = tf;
  tf = shown_values(stored, shown, *volume);
  const TransferFunction before = tf;
  const bool changed = edit();
  tf = tf == before ? stored : stored_values(tf, stored, *volume);
  return changed;
}

}  // namespace crest
