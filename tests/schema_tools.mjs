// What tests/schema_tools.sh runs, beside the packages it uses: node schema_tools.mjs <the project's folder>
import { execFileSync, spawn } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import Ajv from "ajv";
import { parseDocument } from "yaml";

const root = process.argv[2];
const scenes = join(root, "scenes");
const modeline = "# yaml-language-server: $schema=../table.schema.json\n";

// What no schema can see, as it takes more than one value to judge (contracts, references, ids, domains, starts), or what the tools read
// before a schema is asked and do not mind (a tag, depth).
const unseen = /^(E0107|E0117|E0209|E0221|E023[012]|E03\d\d|W05\d\d)$/;
// Seen where a bare number or a sign does it, and not in the examples: ranges of numbers with units, names of colors, expressions.
const unseenExample = /^(E0208|E0215|E0225|E0226)$/;
// The language server takes empty files, merge keys, several documents and a key without a value in braces; it goes on for ever where aliases
// explode, and says nothing.
const unseenByServer = /^(E0101|E0113|E0114|E0116|E0118|E0223)$/;

let failures = 0;
function expect(holds, words) {
    if (holds) return;
    console.log(`FAIL ${words}`);
    ++failures;
}

/** Table files of a folder of scenes/ with their texts. */
function tables(folder) {
    const names = readdirSync(join(scenes, folder)).filter((name) => name.endsWith(".yaml"));
    return names.map((name) => ({ path: join(scenes, folder, name), text: readFileSync(join(scenes, folder, name), "utf8") }));
}

/** Invalid scenes and the wrong examples of `pinfield explain` that a schema can see, as one list of tables. */
function wrongTables(explained) {
    const codesOf = (text) => [...text.matchAll(/^# expect (\S+) \d+:\d+/gm)].map((match) => match[1]);
    const invalid = tables("invalid").map(({ path, text }) => ({ path, text, codes: codesOf(text) }));
    const seen = invalid.filter(({ codes }) => codes.some((code) => !unseen.test(code)));
    const examples = explained.filter(({ code, wrong }) => wrong && !unseen.test(code) && !unseenExample.test(code) && !code.startsWith("E06"));
    return seen.concat(examples.map(({ code, wrong }) => ({ path: join(scenes, "invalid", `${code}.yaml`), text: tableOf(wrong), codes: [code] })));
}

function rightTables(explained) {
    const examples = explained.filter(({ code, right }) => right && !code.startsWith("E06"));
    return examples.map(({ code, right }) => ({ path: join(scenes, "nodes", `${code}.yaml`), text: modeline + tableOf(right) }));
}

/** An example's nodes as the scene of a table; a whole table as it is. */
function tableOf(example) {
    return example.startsWith("- ") ? "pinfield: 1\nscene:\n" + example.replace(/^/gm, "  ").trimEnd() + "\n" : example;
}

/** What the parser or ajv minds, or "". */
function faultOf(text, validate) {
    try {
        const document = parseDocument(text);
        if (document.errors.length > 0) return document.errors[0].message;
        return validate(document.toJS()) ? "" : validate.errors.map((e) => `${e.instancePath} ${e.message}`).join("; ");
    } catch (error) {
        return error.message;  // endless or exploding aliases
    }
}

/** The language server, spoken to as a text editor does (LSP 3.17, over its standard streams). */
class Server {
    constructor(script) {
        this.process = spawn(process.execPath, [script, "--stdio"], { stdio: ["pipe", "pipe", "inherit"] });
        this.received = Buffer.alloc(0);
        this.waiting = new Map();
        this.process.stdout.on("data", (bytes) => this.take(bytes));
    }

    take(bytes) {
        this.received = Buffer.concat([this.received, bytes]);
        for (;;) {
            const head = this.received.indexOf("\r\n\r\n");
            if (head < 0) return;
            const size = Number(/Content-Length: (\d+)/i.exec(this.received.toString("ascii", 0, head))[1]);
            if (this.received.length < head + 4 + size) return;
            const message = JSON.parse(this.received.toString("utf8", head + 4, head + 4 + size));
            this.received = this.received.subarray(head + 4 + size);
            this.answer(message);
        }
    }

    answer(message) {
        if (message.method === "workspace/configuration") this.send({ id: message.id, result: message.params.items.map(() => ({})) });
        else if (message.method && message.id !== undefined) this.send({ id: message.id, result: null });
        const key = message.method === "textDocument/publishDiagnostics" ? message.params.uri : message.method ? undefined : message.id;
        const heard = this.waiting.get(key);
        if (heard) this.waiting.delete(key), heard(message.params ?? message.result);
    }

    send(message) {
        const body = JSON.stringify({ jsonrpc: "2.0", ...message });
        this.process.stdin.write(`Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`);
    }

    /** What comes back under this key; fails after 20 s. */
    heard(key) {
        return new Promise((resolve, reject) => {
            const late = setTimeout(() => reject(new Error(`the language server does not answer: ${key}`)), 20000);
            this.waiting.set(key, (value) => (clearTimeout(late), resolve(value)));
        });
    }

    request(method, params) {
        this.last = (this.last ?? 0) + 1;
        this.send({ id: this.last, method, params });
        return this.heard(this.last);
    }

    async start() {
        await this.request("initialize", { processId: process.pid, rootUri: pathToFileURL(root).href, capabilities: {} });
        this.send({ method: "initialized", params: {} });
        this.send({ method: "workspace/didChangeConfiguration", params: { settings: { yaml: { validate: true, completion: true, hover: true } } } });
    }

    async open({ path, text }) {
        const uri = pathToFileURL(path).href;
        const told = this.heard(uri);
        this.send({ method: "textDocument/didOpen", params: { textDocument: { uri, languageId: "yaml", version: 1, text } } });
        return (await told).diagnostics;
    }

    /** Labels offered at the end of an open text. */
    async offered(table) {
        await this.open(table);
        const lines = table.text.split("\n");
        const position = { line: lines.length - 1, character: lines.at(-1).length };
        const answer = await this.request("textDocument/completion", { textDocument: { uri: pathToFileURL(table.path).href }, position });
        return answer.items.map((item) => item.label);
    }
}

const explained = JSON.parse(execFileSync(join(root, "build/release/bin/pinfield"), ["explain", "--json"], { encoding: "utf8" }));
const right = [...tables("tables"), ...tables("nodes"), ...rightTables(explained)];
const wrong = wrongTables(explained);

const ajv = new Ajv({ strict: true, allowUnionTypes: true });
const validate = ajv.compile(JSON.parse(readFileSync(join(scenes, "table.schema.json"), "utf8")));
for (const { path, text } of right) expect(faultOf(text, validate) === "", `ajv minds ${path}: ${faultOf(text, validate)}`);
for (const { path, text } of wrong) expect(faultOf(text, validate) !== "", `ajv takes ${path}`);

const server = new Server(join(root, "build/schema_tools/node_modules/yaml-language-server/bin/yaml-language-server"));
await server.start();
for (const table of right) {
    const found = await server.open(table);
    expect(found.length === 0, `the language server minds ${table.path}: ${found.map((f) => f.message).join("; ")}`);
}
const served = wrong.filter(({ codes }) => codes.some((code) => !unseen.test(code) && !unseenByServer.test(code)));
for (const table of served) expect((await server.open({ ...table, text: modeline + table.text })).length > 0, `the language server takes ${table.path}`);

const begun = modeline + "pinfield: 1\nscene:\n  - ";
const nodes = await server.offered({ path: join(scenes, "nodes", "begun.yaml"), text: begun });
for (const key of ["circle", "smooth_union", "bumper"]) expect(nodes.includes(key), `${key} is not offered as a node`);
const fields = await server.offered({ path: join(scenes, "nodes", "bumper_begun.yaml"), text: begun + "bumper:\n      radius: 2cm\n      " });
for (const key of ["kick", "threshold", "material"]) expect(fields.includes(key), `${key} is not offered as a field of bumper`);
expect(!fields.includes("swing"), "swing is offered as a field of bumper");

console.log(`${right.length} tables valid to ajv and to the YAML language server, ${wrong.length} refused by ajv and ${served.length} by the server: ${failures} failures`);
server.process.kill();
process.exit(failures === 0 ? 0 : 1);
