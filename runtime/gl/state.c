#include "gl/state.h"

// The last two exist on GL only.
enum { UNPACK_ES = TSU_I_STATE_UNPACK - 2, ROW_LENGTH = 1 };

static const struct {
    uint32_t name;
    int32_t value; // while we upload
} unpack[TSU_I_STATE_UNPACK] = {
    {TSU_I_GL_UNPACK_ALIGNMENT, 1},    {TSU_I_GL_UNPACK_ROW_LENGTH, 0},
    {TSU_I_GL_UNPACK_IMAGE_HEIGHT, 0}, {TSU_I_GL_UNPACK_SKIP_PIXELS, 0},
    {TSU_I_GL_UNPACK_SKIP_ROWS, 0},    {TSU_I_GL_UNPACK_SKIP_IMAGES, 0},
    {TSU_I_GL_UNPACK_SWAP_BYTES, 0},   {TSU_I_GL_UNPACK_LSB_FIRST, 0},
};

static int unpack_count(const struct tsu_i_gl_api *api)
{
    return api->es ? UNPACK_ES : TSU_I_STATE_UNPACK;
}

void tsu_i_state_begin_texture(const struct tsu_i_gl_api *api, struct tsu_i_state *state,
                               uint32_t row_length)
{
    api->GetIntegerv(TSU_I_GL_PIXEL_UNPACK_BUFFER_BINDING, &state->unpack_buffer);
    api->BindBuffer(TSU_I_GL_PIXEL_UNPACK_BUFFER, 0);
    for (int i = 0; i < unpack_count(api); i++) {
        api->GetIntegerv(unpack[i].name, &state->unpack[i]);
        api->PixelStorei(unpack[i].name, i == ROW_LENGTH ? (int32_t)row_length : unpack[i].value);
    }
    if (!api->direct)
        api->GetIntegerv(TSU_I_GL_TEXTURE_BINDING_2D, &state->texture);
}

void tsu_i_state_end_texture(const struct tsu_i_gl_api *api, const struct tsu_i_state *state)
{
    if (!api->direct)
        api->BindTexture(TSU_I_GL_TEXTURE_2D, (uint32_t)state->texture);
    for (int i = 0; i < unpack_count(api); i++)
        api->PixelStorei(unpack[i].name, state->unpack[i]);
    api->BindBuffer(TSU_I_GL_PIXEL_UNPACK_BUFFER, (uint32_t)state->unpack_buffer);
}

void tsu_i_state_begin_buffer(const struct tsu_i_gl_api *api, struct tsu_i_state *state)
{
    if (!api->direct)
        api->GetIntegerv(TSU_I_GL_UNIFORM_BUFFER_BINDING, &state->uniform_buffer);
}

void tsu_i_state_end_buffer(const struct tsu_i_gl_api *api, const struct tsu_i_state *state)
{
    if (!api->direct)
        api->BindBuffer(TSU_I_GL_UNIFORM_BUFFER, (uint32_t)state->uniform_buffer);
}
