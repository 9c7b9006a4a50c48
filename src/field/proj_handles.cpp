// SPDX-License-Identifier: GPL-3.0-or-later
#include "proj_handles.hpp"

#include <proj.h>

namespace selion {

void ProjDeleter::operator()(PJconsts* object) const { proj_destroy(object); }
void ProjDeleter::operator()(pj_ctx* context) const { proj_context_destroy(context); }

void ProjDeleter::operator()(PJ_OBJ_LIST* list) const { proj_list_destroy(list); }
void ProjDeleter::operator()(PJ_OPERATION_FACTORY_CONTEXT* factory) const {
  proj_operation_factory_context_destroy(factory);
}

ProjContext make_proj_context() {
  ProjContext context{proj_context_create()};
  proj_log_level(context.get(), PJ_LOG_NONE);
  proj_context_set_enable_network(context.get(), 0);
  return context;
}

}  // namespace selion
