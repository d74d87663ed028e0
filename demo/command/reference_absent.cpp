// `tsuya reference` where Embree was not found.
#include "arguments.h"
#include "commands.h"

int command_reference(int, char **)
{
    using namespace tsuya::command;
    return complain("reference",
                    "the path tracer is not built in: it needs Embree 3 (libembree-dev), see "
                    "meson -Dreference=enabled.",
                    exit_failure);
}
