// Everything a host may include, in order of need. See README.md for ten lines that shade hair.
#ifndef TSUYA_TSUYA_H
#define TSUYA_TSUYA_H

#include <tsuya/base.h>
#include <tsuya/context.h>
#include <tsuya/model.h>
#include <tsuya/set.h>
#include <tsuya/shader.h>
#include <tsuya/gl.h>
#include <tsuya/hair_color.h>
#include <tsuya/hair_shadow.h>
#include <tsuya/leaf.h>
#include <tsuya/leaf_scale.h>
#include <tsuya/light.h>
#include <tsuya/choose.h>
#include <tsuya/models/deep_opacity.h>
#include <tsuya/models/dual_scattering.h>
#include <tsuya/models/kajiya_kay.h>
#include <tsuya/models/leaf.h>
#include <tsuya/models/leaf_body.h>
#include <tsuya/models/leaf_coarse.h>
#include <tsuya/models/marschner.h>
#include <tsuya/models/opacity_shadow.h>
#include <tsuya/models/plane_parallel_hair.h>

#endif
