// SPDX-License-Identifier: MIT
// Where material records and tables are found. The assembler declares tsu_tables and tsu_records.
//
// A page is 1024 vec4: 8 of header, then 8 for each material. Header:
//   0  1/width, 1/height of the texture, width, height
//   1  half width and height of a cell's band in texture coordinates, texel centre to texel centre,
//      and the distance of its two bands: 63.5/width, 62.9999/height, 64/height

#define TSU_PAGE(k) tsu_records[k]
#define TSU_RECORD(material, k) tsu_records[(material) * 8 + (8 + (k))]
