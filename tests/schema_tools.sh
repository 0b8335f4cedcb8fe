#!/usr/bin/env bash
# tests/schema_tools.sh: the schema in the hands of the tools authors use: ajv, and the YAML language server of VS Code, vim and others. Every
# shipped table is valid to both, found by its modeline; every invalid scene of the kinds a schema can see is refused by both; and the server
# offers nodes and fields. Needs node, npm and, the first time, a network; the packages go to build/schema_tools.
set -euo pipefail
root=$(dirname "$(dirname "$(realpath "$0")")")
tools=$root/build/schema_tools
mkdir -p "$tools"
[[ -d $tools/node_modules/yaml-language-server ]] ||
    npm install --prefix "$tools" --no-audit --no-fund --silent ajv@8.20.0 yaml@2.9.1 yaml-language-server@1.25.0
cp "$root/tests/schema_tools.mjs" "$tools"
node --no-warnings "$tools/schema_tools.mjs" "$root"
