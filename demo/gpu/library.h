// Functions of a shared library that is opened at run time.
#ifndef TSUYA_DEMO_GPU_LIBRARY_H
#define TSUYA_DEMO_GPU_LIBRARY_H

#include <stddef.h>

// One function to find.
struct library_symbol {
    const char *name;
    void *slot; // address of the function pointer to fill
};

// Opens the first of `names` that is there and fills every slot. The library stays open until the
// process ends.
//
// names       file names, in order of preference, ending with NULL
// symbols     what to find, ending with a NULL name
// error       terminated text; on failure a sentence that says what is missing is added to it
// error_size  bytes at `error`, more than the text there needs
//
// Returns: 1 on success, 0 when no library opens or one function is missing; slots before the
//          missing function are filled then.
int library_open(const char *const *names, const struct library_symbol *symbols, char *error,
                 size_t error_size);

#endif
