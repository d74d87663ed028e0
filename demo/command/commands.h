// The subcommands of `tsuya`, and the codes that the process ends with.
//
// argv[0] is the subcommand's own name, argv[1] its first argument. A subcommand prints results on
// standard output and one sentence per error on standard error, and returns the exit code. After
// an error nothing is on standard output and no target file has changed.
#ifndef TSUYA_DEMO_COMMAND_COMMANDS_H
#define TSUYA_DEMO_COMMAND_COMMANDS_H

namespace tsuya::command {

enum {
    exit_ok = 0,
    exit_failure = 1, // the machine: no GL, no memory, a file that cannot be written
    exit_bad_input = 2
};

} // namespace tsuya::command

int command_models(int argc, char **argv);
int command_glsl(int argc, char **argv);
int command_bake(int argc, char **argv);
int command_eval(int argc, char **argv);
int command_bench(int argc, char **argv);
int command_choose(int argc, char **argv);
int command_reference(int argc, char **argv);

// Defined in demo/scene.
int command_compare(int argc, char **argv);
int command_render(int argc, char **argv);
int command_scenes(int argc, char **argv);

#endif
