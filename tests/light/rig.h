// A GPU that evaluates one model under one light or in one environment, once a pixel, with fibre,
// viewer, hair colour and shadow of each pixel drawn at random.
#ifndef TESTS_LIGHT_RIG_H
#define TESTS_LIGHT_RIG_H

#include <tsuya/tsuya.h>

#include <array>
#include <vector>

// What a pixel answers; see question.h.
using Answer = std::array<float, 4>;

// An environment whose radiance has a closed form: a constant and lobes amplitude exp(sharpness
// (direction . axis - 1)).
struct Surroundings {
    static constexpr int lobes = 3;
    float constant = 1.0f;
    float axis[lobes][3] = {}, amplitude[lobes] = {}, sharpness[lobes] = {};
};

enum class Question {
    area,        // luminance: truth, estimate; solid angle: truth, sum of weights
    environment, // luminance: truth, estimate with the dominant light, without it; 1
    bad_input    // sum of weights, sum of luminance, furthest length of a direction from 1; count
};

struct Query {
    Question question = Question::area;
    tsu_light_desc light;        // packed; also the environment's dominant light
    float position[3] = {};      // of the fibre
    Surroundings surroundings;
    float record[36] = {};       // of the environment
    int white = 0;               // 1: no absorption, no shadow
    int fault = 0;               // for bad_input, see the shader
    int grid = 36;               // of the truth
    int width = 32, height = 24; // pixels
    int seed = 1;
};

// Opens a context; exits with a message where there is none.
void rig_open();
void rig_close();
tsu_context *rig_context();

// Choose a model with its defaults. `beta_R`: longitudinal deviation in radians, 0: the default.
void rig_model(const tsu_model *model, float beta_R = 0.0f);
std::vector<Answer> rig_ask(const Query &query);

// Surroundings as the library takes them: 64 x 128 directions.
tsu_environment rig_project(const Surroundings &surroundings);

#endif
