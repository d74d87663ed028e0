// What the files about sets share.
#ifndef TSU_API_SET_H
#define TSU_API_SET_H

#include "bake/pool.h"

#include <tsuya/set.h>

struct tsu_i_pool *tsu_i_set_pool(tsu_set *set);

#endif
