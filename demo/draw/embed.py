#!/usr/bin/env python3
"""Turn text files into one C++ array: embed.py OUTPUT HEADER NAMESPACE ARRAY FILE...

HEADER declares `const Source ARRAY[]` with rows {name, text}; a row of NULLs ends it.
"""
import pathlib
import sys

output, header, namespace, array = sys.argv[1:5]
lines = ['#include "%s"' % header, "", "namespace %s {" % namespace, "",
         "const Source %s[] = {" % array]
for path in sorted(map(pathlib.Path, sys.argv[5:]), key=lambda p: p.name):
    lines.append('    {"%s",' % path.name)
    for text in path.read_text(encoding="utf-8").splitlines():
        text = text.replace("\\", "\\\\").replace('"', '\\"')
        lines.append('     "%s\\n"' % text)
    lines.append("    },")
lines += ["    {nullptr, nullptr},", "};", "", "} // namespace %s" % namespace, ""]
pathlib.Path(output).write_text("\n".join(lines), encoding="utf-8")
