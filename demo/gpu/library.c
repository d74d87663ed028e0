#include "library.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

int library_open(const char *const *names, const struct library_symbol *symbols, char *error,
                 size_t error_size)
{
    void *library = NULL;
    const size_t used = strlen(error);
    for (size_t i = 0; names[i] && !library; i++) {
        library = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    }
    if (!library) {
        snprintf(error + used, error_size - used, "cannot open %s. ", names[0]);
        return 0;
    }
    for (size_t i = 0; symbols[i].name; i++) {
        void *const address = dlsym(library, symbols[i].name);
        if (!address) {
            snprintf(error + used, error_size - used, "the library has no function %s. ",
                     symbols[i].name);
            dlclose(library);
            return 0;
        }
        // memcpy because ISO C has no cast between object and function pointers.
        memcpy(symbols[i].slot, &address, sizeof address);
    }
    return 1;
}
