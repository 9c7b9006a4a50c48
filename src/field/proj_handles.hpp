// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

// PROJ's own names for its opaque handles: proj.h stays in the .cpp files.
struct PJconsts;
struct pj_ctx;
struct PJ_OBJ_LIST;
struct PJ_OPERATION_FACTORY_CONTEXT;

namespace selion {

struct ProjDeleter {
  void operator()(PJconsts* object) const;
  void operator()(pj_ctx* context) const;
  void operator()(PJ_OBJ_LIST* list) const;
  void operator()(PJ_OPERATION_FACTORY_CONTEXT* factory) const;
};
using ProjObject = std::unique_ptr<PJconsts, ProjDeleter>;
using ProjContext = std::unique_ptr<pj_ctx, ProjDeleter>;
using ProjList = std::unique_ptr<PJ_OBJ_LIST, ProjDeleter>;
using ProjFactory = std::unique_ptr<PJ_OPERATION_FACTORY_CONTEXT, ProjDeleter>;

/// Silent, and never on the network: a plan must not hang on a download.
ProjContext make_proj_context();

}  // namespace selion
