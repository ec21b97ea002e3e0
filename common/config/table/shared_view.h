#pragma once

#include "common/config/table/setting_spec.h"

namespace slicefarm::config {

/// What settings that processes share may set: the options of stages that all have.
template <class Job>
struct SharedView {
  explicit SharedView(Job& job) : slicing(job.slicing) {}

  Like<SlicingOptions, Job>& slicing;
};

///     Bind([](auto& s) -> auto& { return s.slicing.objects[0].layer_height_nm; })
template <Scale kScale = Scale::kSame, class Member>
Field Bind(Member member) {
  return BindTo<SharedView, kScale>(member);
}

}  // namespace slicefarm::config
