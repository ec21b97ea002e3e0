#pragma once

#include <string>

#include "common/rpc/client/channel.h"
#include "services/coordinator/remote/remote_milling.h"
#include "services/coordinator/remote/remote_planning.h"
#include "services/coordinator/remote/remote_slicing.h"
#include "services/coordinator/remote/remote_stages.h"
#include "services/coordinator/remote/remote_texture.h"
#include "services/coordinator/remote/remote_worker.h"

namespace slicefarm {

/// All stages and the worker of one host, as seen by its clients.
struct RemoteClients {
  explicit RemoteClients(const std::string& address, const coordinator::RemoteOptions& options = {},
                         const rpc::ChannelOptions& channel = {})
      : replica(rpc::MakeChannel(address, channel)),
        slicing(replica, options),
        arranging(replica, options),
        placing(replica, options),
        planning(replica, options),
        beading(replica, options),
        infill(replica, options),
        ordering(replica, options),
        motion(replica, options),
        exposure(replica, options),
        milling(replica, options),
        texture(replica, options),
        worker(replica, options) {}

  coordinator::SingleReplica replica;
  coordinator::RemoteSlicing slicing;
  coordinator::RemoteArranging arranging;
  coordinator::RemotePlacing placing;
  coordinator::RemotePlanning planning;
  coordinator::RemoteBeading beading;
  coordinator::RemoteInfill infill;
  coordinator::RemoteOrdering ordering;
  coordinator::RemoteMotion motion;
  coordinator::RemoteExposure exposure;
  coordinator::RemoteMilling milling;
  coordinator::RemoteTexture texture;
  coordinator::RemoteWorker worker;
};

}  // namespace slicefarm
