// SPDX-License-Identifier: MIT
// Where material records and tables are found. The assembler declares tsu_tables and tsu_records.
//
// A page is 1024 vec4: 8 of header, then 8 for each material. The header's first vec4 holds
// 1/width, 1/height, width and height of the texture; the others are 0.

#define TSU_RECORD(material, k) tsu_records[(material) * 8 + (8 + (k))]
