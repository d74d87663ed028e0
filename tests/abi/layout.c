// Layout of every public struct on LP64. A number here never changes; a struct grows at its end
// with new lines here. Compiling this file is the test. Over 500 lines: one line a field.
#include <tsuya/tsuya.h>

#define SIZE(type, bytes) _Static_assert(sizeof(type) == (bytes), #type " has another size")
#define AT(type, field, bytes)                                                                    \
    _Static_assert(offsetof(type, field) == (bytes), #type "." #field " has moved")

#if defined(__LP64__) || defined(_WIN64)

SIZE(tsu_context_desc, 80);
AT(tsu_context_desc, struct_size, 0);
AT(tsu_context_desc, flags, 4);
AT(tsu_context_desc, version, 8);
AT(tsu_context_desc, reserved, 12);
AT(tsu_context_desc, allocate, 16);
AT(tsu_context_desc, allocate_user, 24);
AT(tsu_context_desc, log, 32);
AT(tsu_context_desc, log_user, 40);
AT(tsu_context_desc, jobs, 48);
AT(tsu_context_desc, jobs_user, 56);
AT(tsu_context_desc, read, 64);
AT(tsu_context_desc, read_user, 72);

SIZE(tsu_gl_desc, 24);
AT(tsu_gl_desc, struct_size, 0);
AT(tsu_gl_desc, flags, 4);
AT(tsu_gl_desc, get_proc_address, 8);
AT(tsu_gl_desc, user, 16);

SIZE(tsu_gl_bindings_info, 32);
AT(tsu_gl_bindings_info, struct_size, 0);
AT(tsu_gl_bindings_info, flags, 4);
AT(tsu_gl_bindings_info, texture, 8);
AT(tsu_gl_bindings_info, buffer, 12);
AT(tsu_gl_bindings_info, offset, 16);
AT(tsu_gl_bindings_info, size, 24);

SIZE(tsu_hair_preset_info, 56);
AT(tsu_hair_preset_info, struct_size, 0);
AT(tsu_hair_preset_info, flags, 4);
AT(tsu_hair_preset_info, name, 8);
AT(tsu_hair_preset_info, eumelanin, 16);
AT(tsu_hair_preset_info, pheomelanin, 24);
AT(tsu_hair_preset_info, sigma_a, 32);

SIZE(tsu_hair_head_desc, 32);
AT(tsu_hair_head_desc, struct_size, 0);
AT(tsu_hair_head_desc, flags, 4);
AT(tsu_hair_head_desc, eta, 8);
AT(tsu_hair_head_desc, alpha_R, 12);
AT(tsu_hair_head_desc, beta_R, 16);
AT(tsu_hair_head_desc, beta_az, 20);
AT(tsu_hair_head_desc, scale_shifts, 24);
AT(tsu_hair_head_desc, reserved, 28);

SIZE(tsu_hair_head_curve, 168);
AT(tsu_hair_head_curve, struct_size, 0);
AT(tsu_hair_head_curve, flags, 4);
AT(tsu_hair_head_curve, eta, 8);
AT(tsu_hair_head_curve, alpha_R, 12);
AT(tsu_hair_head_curve, beta_R, 16);
AT(tsu_hair_head_curve, beta_az, 20);
AT(tsu_hair_head_curve, scale_shifts, 24);
AT(tsu_hair_head_curve, reserved, 28);
AT(tsu_hair_head_curve, albedo, 32);

SIZE(tsu_hair_shadow_desc, 96);
AT(tsu_hair_shadow_desc, struct_size, 0);
AT(tsu_hair_shadow_desc, flags, 4);
AT(tsu_hair_shadow_desc, model, 8);
AT(tsu_hair_shadow_desc, params, 16);
AT(tsu_hair_shadow_desc, centre, 24);
AT(tsu_hair_shadow_desc, radius, 36);
AT(tsu_hair_shadow_desc, light, 40);
AT(tsu_hair_shadow_desc, width, 52);
AT(tsu_hair_shadow_desc, length, 56);
AT(tsu_hair_shadow_desc, volume, 60);
AT(tsu_hair_shadow_desc, spacing, 64);
AT(tsu_hair_shadow_desc, size, 68);
AT(tsu_hair_shadow_desc, least_size, 72);
AT(tsu_hair_shadow_desc, most_size, 76);
AT(tsu_hair_shadow_desc, tile_x, 80);
AT(tsu_hair_shadow_desc, tile_y, 84);
AT(tsu_hair_shadow_desc, reserved, 88);

SIZE(tsu_hair_shadow_plan, 344);
AT(tsu_hair_shadow_plan, struct_size, 0);
AT(tsu_hair_shadow_plan, flags, 4);
AT(tsu_hair_shadow_plan, size, 8);
AT(tsu_hair_shadow_plan, layers, 12);
AT(tsu_hair_shadow_plan, target_count, 16);
AT(tsu_hair_shadow_plan, pass_count, 20);
AT(tsu_hair_shadow_plan, spacing, 24);
AT(tsu_hair_shadow_plan, texel, 28);
AT(tsu_hair_shadow_plan, near_plane, 32);
AT(tsu_hair_shadow_plan, far_plane, 36);
AT(tsu_hair_shadow_plan, boundary, 40);
AT(tsu_hair_shadow_plan, opacity, 76);
AT(tsu_hair_shadow_plan, color, 80);
AT(tsu_hair_shadow_plan, reserved, 84);
AT(tsu_hair_shadow_plan, to_light, 88);
AT(tsu_hair_shadow_plan, record, 152);

SIZE(tsu_hair_shadow_target_info, 40);
AT(tsu_hair_shadow_target_info, struct_size, 0);
AT(tsu_hair_shadow_target_info, flags, 4);
AT(tsu_hair_shadow_target_info, name, 8);
AT(tsu_hair_shadow_target_info, format, 16);
AT(tsu_hair_shadow_target_info, clear, 20);

SIZE(tsu_hair_shadow_pass_info, 40);
AT(tsu_hair_shadow_pass_info, struct_size, 0);
AT(tsu_hair_shadow_pass_info, flags, 4);
AT(tsu_hair_shadow_pass_info, name, 8);
AT(tsu_hair_shadow_pass_info, targets, 16);
AT(tsu_hair_shadow_pass_info, depth_test, 20);
AT(tsu_hair_shadow_pass_info, blend_add, 24);
AT(tsu_hair_shadow_pass_info, function, 32);

SIZE(tsu_deep_opacity_params, 24);
AT(tsu_deep_opacity_params, struct_size, 0);
AT(tsu_deep_opacity_params, flags, 4);
AT(tsu_deep_opacity_params, opacity, 8);
AT(tsu_deep_opacity_params, spacings, 12);
AT(tsu_deep_opacity_params, layers, 16);
AT(tsu_deep_opacity_params, growth, 20);

SIZE(tsu_opacity_shadow_params, 24);
AT(tsu_opacity_shadow_params, struct_size, 0);
AT(tsu_opacity_shadow_params, flags, 4);
AT(tsu_opacity_shadow_params, opacity, 8);
AT(tsu_opacity_shadow_params, spacings, 12);
AT(tsu_opacity_shadow_params, layers, 16);
AT(tsu_opacity_shadow_params, growth, 20);

SIZE(tsu_model_info, 64);
AT(tsu_model_info, struct_size, 0);
AT(tsu_model_info, flags, 4);
AT(tsu_model_info, name, 8);
AT(tsu_model_info, title, 16);
AT(tsu_model_info, source, 24);
AT(tsu_model_info, params_size, 32);
AT(tsu_model_info, parameter_count, 40);
AT(tsu_model_info, table_count, 44);
AT(tsu_model_info, error_count, 48);
AT(tsu_model_info, input_count, 52);
AT(tsu_model_info, function_count, 56);
AT(tsu_model_info, variant_count, 60);

SIZE(tsu_variant_info, 32);
AT(tsu_variant_info, struct_size, 0);
AT(tsu_variant_info, flags, 4);
AT(tsu_variant_info, name, 8);
AT(tsu_variant_info, help, 16);
AT(tsu_variant_info, inputs, 24);

SIZE(tsu_parameter_info, 72);
AT(tsu_parameter_info, struct_size, 0);
AT(tsu_parameter_info, flags, 4);
AT(tsu_parameter_info, name, 8);
AT(tsu_parameter_info, unit, 16);
AT(tsu_parameter_info, help, 24);
AT(tsu_parameter_info, offset, 32);
AT(tsu_parameter_info, count, 40);
AT(tsu_parameter_info, rebakes, 44);
AT(tsu_parameter_info, minimum, 48);
AT(tsu_parameter_info, maximum, 56);
AT(tsu_parameter_info, default_value, 64);

SIZE(tsu_table_info, 48);
AT(tsu_table_info, struct_size, 0);
AT(tsu_table_info, flags, 4);
AT(tsu_table_info, name, 8);
AT(tsu_table_info, axes, 16);
AT(tsu_table_info, channels, 24);
AT(tsu_table_info, width, 32);
AT(tsu_table_info, height, 36);
AT(tsu_table_info, bytes, 40);

SIZE(tsu_error_info, 40);
AT(tsu_error_info, struct_size, 0);
AT(tsu_error_info, flags, 4);
AT(tsu_error_info, name, 8);
AT(tsu_error_info, measure, 16);
AT(tsu_error_info, range, 24);
AT(tsu_error_info, value, 32);

SIZE(tsu_input_info, 32);
AT(tsu_input_info, struct_size, 0);
AT(tsu_input_info, flags, 4);
AT(tsu_input_info, name, 8);
AT(tsu_input_info, type, 16);
AT(tsu_input_info, help, 24);

SIZE(tsu_function_info, 32);
AT(tsu_function_info, struct_size, 0);
AT(tsu_function_info, flags, 4);
AT(tsu_function_info, name, 8);
AT(tsu_function_info, help, 16);
AT(tsu_function_info, input_count, 24);
AT(tsu_function_info, output_count, 28);

SIZE(tsu_value_info, 56);
AT(tsu_value_info, struct_size, 0);
AT(tsu_value_info, flags, 4);
AT(tsu_value_info, name, 8);
AT(tsu_value_info, unit, 16);
AT(tsu_value_info, help, 24);
AT(tsu_value_info, minimum, 32);
AT(tsu_value_info, maximum, 40);
AT(tsu_value_info, default_value, 48);

SIZE(tsu_leaf_body_params, 68);
AT(tsu_leaf_body_params, struct_size, 0);
AT(tsu_leaf_body_params, flags, 4);
AT(tsu_leaf_body_params, n, 8);
AT(tsu_leaf_body_params, scatter_top, 12);
AT(tsu_leaf_body_params, absorption_top, 24);
AT(tsu_leaf_body_params, scatter_bottom, 36);
AT(tsu_leaf_body_params, absorption_bottom, 48);
AT(tsu_leaf_body_params, pigment, 60);
AT(tsu_leaf_body_params, thickness, 64);

SIZE(tsu_leaf_params, 72);
AT(tsu_leaf_params, struct_size, 0);
AT(tsu_leaf_params, flags, 4);
AT(tsu_leaf_params, n, 8);
AT(tsu_leaf_params, scatter_top, 12);
AT(tsu_leaf_params, absorption_top, 24);
AT(tsu_leaf_params, scatter_bottom, 36);
AT(tsu_leaf_params, absorption_bottom, 48);
AT(tsu_leaf_params, pigment, 60);
AT(tsu_leaf_params, thickness, 64);
AT(tsu_leaf_params, roughness, 68);

SIZE(tsu_kajiya_kay_params, 32);
AT(tsu_kajiya_kay_params, struct_size, 0);
AT(tsu_kajiya_kay_params, flags, 4);
AT(tsu_kajiya_kay_params, eta, 8);
AT(tsu_kajiya_kay_params, alpha_R, 12);
AT(tsu_kajiya_kay_params, beta_R, 16);
AT(tsu_kajiya_kay_params, sigma_a, 20);

SIZE(tsu_marschner_params, 40);
AT(tsu_marschner_params, struct_size, 0);
AT(tsu_marschner_params, flags, 4);
AT(tsu_marschner_params, eta, 8);
AT(tsu_marschner_params, alpha_R, 12);
AT(tsu_marschner_params, beta_R, 16);
AT(tsu_marschner_params, beta_az, 20);
AT(tsu_marschner_params, sigma_a, 24);
AT(tsu_marschner_params, scale_shifts, 36);

SIZE(tsu_dual_scattering_params, 48);
AT(tsu_dual_scattering_params, struct_size, 0);
AT(tsu_dual_scattering_params, flags, 4);
AT(tsu_dual_scattering_params, eta, 8);
AT(tsu_dual_scattering_params, alpha_R, 12);
AT(tsu_dual_scattering_params, beta_R, 16);
AT(tsu_dual_scattering_params, beta_az, 20);
AT(tsu_dual_scattering_params, sigma_a, 24);
AT(tsu_dual_scattering_params, scale_shifts, 36);
AT(tsu_dual_scattering_params, d_f, 40);
AT(tsu_dual_scattering_params, d_b, 44);

SIZE(tsu_plane_parallel_hair_params, 48);
AT(tsu_plane_parallel_hair_params, struct_size, 0);
AT(tsu_plane_parallel_hair_params, flags, 4);
AT(tsu_plane_parallel_hair_params, eta, 8);
AT(tsu_plane_parallel_hair_params, alpha_R, 12);
AT(tsu_plane_parallel_hair_params, beta_R, 16);
AT(tsu_plane_parallel_hair_params, beta_az, 20);
AT(tsu_plane_parallel_hair_params, sigma_a, 24);
AT(tsu_plane_parallel_hair_params, scale_shifts, 36);
AT(tsu_plane_parallel_hair_params, d_f, 40);
AT(tsu_plane_parallel_hair_params, d_b, 44);

SIZE(tsu_leaf_pigments, 80);
AT(tsu_leaf_pigments, struct_size, 0);
AT(tsu_leaf_pigments, flags, 4);
AT(tsu_leaf_pigments, N, 8);
AT(tsu_leaf_pigments, chlorophyll, 16);
AT(tsu_leaf_pigments, carotenoids, 24);
AT(tsu_leaf_pigments, anthocyanins, 32);
AT(tsu_leaf_pigments, brown, 40);
AT(tsu_leaf_pigments, water, 48);
AT(tsu_leaf_pigments, dry_matter, 56);
AT(tsu_leaf_pigments, n, 64);
AT(tsu_leaf_pigments, bottom, 72);

SIZE(tsu_leaf_reflectance, 88);
AT(tsu_leaf_reflectance, struct_size, 0);
AT(tsu_leaf_reflectance, flags, 4);
AT(tsu_leaf_reflectance, n, 8);
AT(tsu_leaf_reflectance, R_top, 16);
AT(tsu_leaf_reflectance, R_bottom, 40);
AT(tsu_leaf_reflectance, T, 64);

SIZE(tsu_leaf_report, 112);
AT(tsu_leaf_report, struct_size, 0);
AT(tsu_leaf_report, flags, 4);
AT(tsu_leaf_report, R_top, 8);
AT(tsu_leaf_report, R_bottom, 32);
AT(tsu_leaf_report, T, 56);
AT(tsu_leaf_report, residual, 80);
AT(tsu_leaf_report, limited, 104);
AT(tsu_leaf_report, raised, 108);

SIZE(tsu_leaf_scale_desc, 88);
AT(tsu_leaf_scale_desc, struct_size, 0);
AT(tsu_leaf_scale_desc, flags, 4);
AT(tsu_leaf_scale_desc, method, 8);
AT(tsu_leaf_scale_desc, gaussians, 12);
AT(tsu_leaf_scale_desc, n, 16);
AT(tsu_leaf_scale_desc, g, 20);
AT(tsu_leaf_scale_desc, thickness, 24);
AT(tsu_leaf_scale_desc, share_top, 28);
AT(tsu_leaf_scale_desc, scatter_top, 32);
AT(tsu_leaf_scale_desc, absorption_top, 44);
AT(tsu_leaf_scale_desc, scatter_bottom, 56);
AT(tsu_leaf_scale_desc, absorption_bottom, 68);
AT(tsu_leaf_scale_desc, fraction, 80);
AT(tsu_leaf_scale_desc, reserved, 84);

SIZE(tsu_leaf_scale, 312);
AT(tsu_leaf_scale, struct_size, 0);
AT(tsu_leaf_scale, flags, 4);
AT(tsu_leaf_scale, gaussians, 8);
AT(tsu_leaf_scale, thickness, 12);
AT(tsu_leaf_scale, fraction, 16);
AT(tsu_leaf_scale, fit_error, 20);
AT(tsu_leaf_scale, reflectance, 24);
AT(tsu_leaf_scale, transmittance, 36);
AT(tsu_leaf_scale, straight, 48);
AT(tsu_leaf_scale, reflected_radius, 60);
AT(tsu_leaf_scale, transmitted_radius, 72);
AT(tsu_leaf_scale, reflected, 84);
AT(tsu_leaf_scale, transmitted, 180);
AT(tsu_leaf_scale, refusal, 276);
AT(tsu_leaf_scale, refusal_value, 288);
AT(tsu_leaf_scale, total_error, 300);

SIZE(tsu_leaf_verdict, 40);
AT(tsu_leaf_verdict, struct_size, 0);
AT(tsu_leaf_verdict, flags, 4);
AT(tsu_leaf_verdict, pixel_error, 8);
AT(tsu_leaf_verdict, curvature_error, 16);
AT(tsu_leaf_verdict, pixel, 24);
AT(tsu_leaf_verdict, curvature, 32);

SIZE(tsu_light_desc, 88);
AT(tsu_light_desc, struct_size, 0);
AT(tsu_light_desc, flags, 4);
AT(tsu_light_desc, kind, 8);
AT(tsu_light_desc, samples, 12);
AT(tsu_light_desc, color, 16);
AT(tsu_light_desc, angle, 28);
AT(tsu_light_desc, direction, 32);
AT(tsu_light_desc, least, 44);
AT(tsu_light_desc, position, 48);
AT(tsu_light_desc, reserved, 60);
AT(tsu_light_desc, x, 64);
AT(tsu_light_desc, y, 76);

SIZE(tsu_environment_desc, 40);
AT(tsu_environment_desc, struct_size, 0);
AT(tsu_environment_desc, flags, 4);
AT(tsu_environment_desc, radiance, 8);
AT(tsu_environment_desc, user, 16);
AT(tsu_environment_desc, count, 24);
AT(tsu_environment_desc, samples, 28);
AT(tsu_environment_desc, threshold, 32);
AT(tsu_environment_desc, reserved, 36);

SIZE(tsu_environment, 184);
AT(tsu_environment, struct_size, 0);
AT(tsu_environment, flags, 4);
AT(tsu_environment, light_direction, 8);
AT(tsu_environment, light_angle, 20);
AT(tsu_environment, light_irradiance, 24);
AT(tsu_environment, smoothing, 36);
AT(tsu_environment, record, 40);

SIZE(tsu_set_desc, 16);
AT(tsu_set_desc, struct_size, 0);
AT(tsu_set_desc, flags, 4);
AT(tsu_set_desc, max_texture_size, 8);
AT(tsu_set_desc, max_materials, 12);

SIZE(tsu_set_info, 56);
AT(tsu_set_info, struct_size, 0);
AT(tsu_set_info, flags, 4);
AT(tsu_set_info, material_count, 8);
AT(tsu_set_info, page_count, 12);
AT(tsu_set_info, table_count, 16);
AT(tsu_set_info, stale_count, 20);
AT(tsu_set_info, width, 24);
AT(tsu_set_info, height, 28);
AT(tsu_set_info, generation, 32);
AT(tsu_set_info, texture_generation, 40);
AT(tsu_set_info, id, 48);

SIZE(tsu_region, 24);
AT(tsu_region, x, 0);
AT(tsu_region, y, 4);
AT(tsu_region, width, 8);
AT(tsu_region, height, 12);
AT(tsu_region, generation, 16);

SIZE(tsu_shader_desc, 48);
AT(tsu_shader_desc, struct_size, 0);
AT(tsu_shader_desc, flags, 4);
AT(tsu_shader_desc, target, 8);
AT(tsu_shader_desc, model_count, 12);
AT(tsu_shader_desc, models, 16);
AT(tsu_shader_desc, function, 24);
AT(tsu_shader_desc, array_materials, 28);
AT(tsu_shader_desc, set, 32);
AT(tsu_shader_desc, sampler_binding, 36);
AT(tsu_shader_desc, block_binding, 40);
AT(tsu_shader_desc, reserved, 44);

#endif

// Numbers that hosts store: never renumbered.
#define IS(name, value) _Static_assert((name) == (value), #name " has another value")
IS(TSU_OK, 0);
IS(TSU_E_PARAMETER, -1);
IS(TSU_E_STRUCT, -2);
IS(TSU_E_VERSION, -3);
IS(TSU_E_MEMORY, -4);
IS(TSU_E_LIMIT, -5);
IS(TSU_E_UNSUPPORTED, -6);
IS(TSU_E_STATE, -7);
IS(TSU_E_HOST, -8);
IS(TSU_LOG_ERROR, 1);
IS(TSU_LOG_WARNING, 2);
IS(TSU_LOG_INFO, 3);
IS(TSU_GL_CHECK, 1);
IS(TSU_INPUT_EXTRA, 1);
IS(TSU_FUNCTION_INPUTS, 48);
IS(TSU_FUNCTION_OUTPUTS, 8);
IS(TSU_FUNCTION_REFERENCE_ONLY, 1);
IS(TSU_VALUE_MATERIAL, 1);
IS(TSU_PAGE_MATERIALS, 127);
IS(TSU_RECORD_VEC4, 8);
IS(TSU_PAGE_VEC4, 1024);
IS(TSU_PAGE_BYTES, 16384);
IS(TSU_CELL, 128);
IS(TSU_TARGET_330, 1);
IS(TSU_TARGET_410, 2);
IS(TSU_TARGET_450, 3);
IS(TSU_TARGET_300ES, 4);
IS(TSU_TARGET_310ES, 5);
IS(TSU_TARGET_VULKAN, 6);
IS(TSU_SHADER_ARRAY, 1);
IS(TSU_SHADER_PROBE, 2);
IS(TSU_SHADER_HARNESS, 4);
IS(TSU_MODEL_SHADOW, 1);
IS(TSU_HAIR_HEAD_NODES, 17);
IS(TSU_HAIR_SHADOW_LAYERS, 8);
IS(TSU_HAIR_SHADOW_RECORD_VEC4, 12);
IS(TSU_HAIR_SHADOW_UNKNOWN, 1000);
IS(TSU_HAIR_SHADOW_POINT, 1);
IS(TSU_HAIR_SHADOW_ZERO_TO_ONE, 2);
IS(TSU_HAIR_SHADOW_BLEND_32F, 4);
IS(TSU_HAIR_SHADOW_BLEND_16F, 8);
IS(TSU_HAIR_SHADOW_EMPTY, 1);
IS(TSU_HAIR_SHADOW_PARTIAL, 2);
IS(TSU_SHADER_LIGHTS, 16);
IS(TSU_SHADER_BLUR, 32);
IS(TSU_LEAF_TRANSPORT, 1);
IS(TSU_LEAF_MULTIPOLE, 2);
IS(TSU_LEAF_DIPOLE, 3);
IS(TSU_LEAF_BETTER_DIPOLE, 4);
IS(TSU_LEAF_PHOTON_BEAM, 5);
IS(TSU_LEAF_LIT_BELOW, 1);
IS(TSU_LEAF_GAUSSIANS, 6);
IS(TSU_LEAF_ABSORBS, 1);
IS(TSU_LEAF_THIN, 2);
IS(TSU_LEAF_THICK, 3);
IS(TSU_LEAF_TOTAL, 4);
IS(TSU_LEAF_PIXEL_REFLECTED, 1);
IS(TSU_LEAF_PIXEL_TRANSMITTED, 2);
IS(TSU_LEAF_CURVED_REFLECTED, 4);
IS(TSU_LEAF_CURVED_TRANSMITTED, 8);
IS(TSU_LIGHT_DIRECTIONAL, 1);
IS(TSU_LIGHT_POINT, 2);
IS(TSU_LIGHT_RECT, 3);
IS(TSU_LIGHT_DISK, 4);
IS(TSU_LIGHT_TWO_SIDED, 1);
IS(TSU_LIGHT_RECORD_VEC4, 4);
IS(TSU_LIGHT_SAMPLES, 64);
IS(TSU_ENVIRONMENT_RECORD_VEC4, 9);
IS(TSU_FORMAT_DEPTH24, 1);
IS(TSU_FORMAT_RGBA32F, 2);
IS(TSU_FORMAT_RGBA16F, 3);
IS(TSU_FORMAT_RGBA8, 4);

int main(void)
{
    return 0;
}
