#include "report/site/formulas.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "report/pages/markup.hpp"
#include "report/site/page.hpp"
#include "report/study/run_program.hpp"

namespace oddity::html {

namespace fs = std::filesystem;

namespace {

constexpr char formula_begins = '\x02', formula_ends = '\x03';

/// What node runs: formulas as a JSON list on its standard input, and into the file that is named a list of
/// as many [MathML] or [null, "why not"]. Of KaTeX's MathML it leaves out what changes nothing, and makes
/// bold letters characters of their own, as browsers know no other way. A long formula is cut before its
/// relations and after its commas, where a line may then end.
constexpr const char* typesetter = R"js(
const katex = require('/usr/share/nodejs/katex');
const fs = require('fs');
const closing = new Set([')', ']', '}', '|', '‖', '!', '′', '⟩']), opening = new Set(['(', '[', '{', '⟨']);
const relations = new Set(['=', '<', '>', '≤', '≥', '≠', '≈', '→', '⇒', '⇔', '≡', '∈', '↔', '∼', '≪', '≫']);
const closers = /^[)\]}⟩]$/;

const safe = (text) => text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');

function letter(c, bold, italic) {
  const at = c.codePointAt(0);
  const from = (first, start) => String.fromCodePoint(start + at - first);
  if (c >= 'A' && c <= 'Z') return from(65, italic ? 0x1D468 : 0x1D400);
  if (c >= 'a' && c <= 'z') return from(97, italic ? 0x1D482 : 0x1D41A);
  if (c >= '0' && c <= '9') return from(48, 0x1D7CE);
  if (c >= 'Α' && c <= 'Ω') return from(0x391, italic ? 0x1D71C : 0x1D6A8);
  if (c >= 'α' && c <= 'ω') return from(0x3B1, italic ? 0x1D736 : 0x1D6C2);
  return c;
}

// A node: {tag, text} or {tag, children}, with attributes {name: value}.
function plain(node) {
  if (node.text !== undefined) return { tag: '', attributes: {}, text: node.text };
  if (node.character !== undefined) return { tag: 'mtext', attributes: {}, text: node.character || '\u2009' };
  const attributes = Object.assign({}, node.attributes);
  let children = (node.children || []).map(plain).filter((child) => child.tag !== 'annotation');
  if (/^(semantics|mstyle|mpadded|mrow)$/.test(node.type || '') && children.length === 1 && children[0].tag !== '')
    return children[0];
  if (!node.type) return { tag: 'mrow', attributes: {}, children };
  if (node.type === 'mstyle') return { tag: 'mrow', attributes: {}, children };
  if (children.length > 0 && children.every((child) => child.tag === '')) {
    let text = children.map((child) => child.text).join('');
    const variant = attributes.mathvariant;
    if (variant === 'bold' || variant === 'bold-italic') {
      text = [...text].map((c) => letter(c, true, variant === 'bold-italic')).join('');
      delete attributes.mathvariant;
    }
    if (variant === 'normal' && !/^[A-Za-zΑ-Ωα-ω∂∇ℓ]$/.test(text)) delete attributes.mathvariant;
    if (attributes.mathvariant === 'normal') return { tag: 'mtext', attributes: {}, text };
    delete attributes.separator;
    if (node.type === 'mo' && String(attributes.stretchy) === 'false' && Object.keys(attributes).length === 1)
      return { tag: 'mi', attributes: {}, text };
    return { tag: node.type, attributes, text };
  }
  if (node.type === 'mover') delete attributes.accent;
  return { tag: node.type, attributes, children: operators(children, /^(mrow|math|mtd|msqrt)$/.test(node.type)) };
}

const operator = (node) => node && (node.tag === 'mo' || opening.has(node.text));

// The name of a function stands apart from its argument; a sign after an operator, or after what opens, belongs to
// what follows it.
function operators(nodes, in_row = true) {
  const named = (node) => node.tag === 'mrow' && node.children.length === 2 && node.children[1].text === '\u2061';
  const children = nodes.map((node, i) => {
    if (!named(node) || node.children[0].text === undefined) return node;
    const before = nodes[i - 1], after = nodes[i + 1];
    const apart = (beside) => in_row && beside && !operator(beside) && !closing.has(beside.text) ? '\u2009' : '';
    return { tag: 'mi', attributes: {}, text: apart(before) + node.children[0].text + apart(after) };
  });
  children.forEach((child, i) => {
    if (child.tag === 'mo' && /^[−+±∓]$/.test(child.text) && operator(children[i - 1])) child.attributes.form = 'prefix';
  });
  return children;
}

// What stands upright without a space about it; neighbours are one.
const upright = (node) => node.tag === 'mtext' || (node.tag === 'mi' && /^[()[\]\/|‖!′⟨⟩]+$/.test(node.text));
function joined(nodes) {
  const all = [];
  for (const node of nodes) {
    const last = all[all.length - 1];
    if (last && upright(last) && upright(node)) all[all.length - 1] = { tag: 'mtext', attributes: {}, text: last.text + node.text };
    else all.push(node);
  }
  return all;
}

function written(node) {
  const attributes = Object.entries(node.attributes).map(([name, value]) => ` ${name}="${safe(String(value))}"`).join('');
  const children = node.tag === 'mrow' || node.tag === 'msqrt' ? joined(node.children) : node.children;
  const inside = children ? children.map(written).join('') : safe(node.text);
  return `<${node.tag}${attributes}>${inside}</${node.tag}>`;
}

const width = (node) => node.children ? node.children.reduce((sum, child) => sum + width(child), 0) : [...node.text].length;

// What a node begins with, of which all else is an index or a power.
const last = (node) => node.text !== undefined ? node.text : /^msu[bp]/.test(node.tag) ? last(node.children[0]) : '';

// Pieces of a long formula, none of them much shorter than `least` letters.
function pieces(nodes, least) {
  const all = [[]];
  let depth = 0, long = 0;
  nodes.forEach((node, i) => {
    if (opening.has(node.text)) ++depth;
    if (closers.test(last(node))) --depth;
    const relation = node.tag === 'mo' && relations.has(node.text);
    const sum = node.tag === 'mo' && /^[−+]$/.test(node.text) && !node.attributes.form;
    const after = i > 0 && nodes[i - 1].tag === 'mo' && nodes[i - 1].text === ',';
    if (depth === 0 && i > 0 && ((relation && long > least / 2) || ((sum || after) && long > least))) {
      if (sum) node.attributes.form = 'infix';
      all.push([]);
      long = 0;
    }
    all[all.length - 1].push(node);
    long += width(node);
  });
  return all;
}

function typeset(tex) {
  const tree = katex.__renderToDomTree(tex, { output: 'mathml', throwOnError: true, strict: 'ignore', trust: false });
  const math = tree.children.find((child) => child.type === 'math');
  const root = plain({ type: 'mrow', children: math.children });
  const nodes = root.tag === 'mrow' ? operators(root.children) : [root];
  const parts = width(root) > 16 ? pieces(nodes, 12) : [nodes];
  return parts.map((part) => '<math>' + joined(part).map(written).join('') + '</math>').join('');
}

const all = JSON.parse(fs.readFileSync(0, 'utf8')).map((tex) => {
  try { return [typeset(tex)]; } catch (error) { return [null, error.message]; }
});
fs.writeFileSync(process.argv[1], JSON.stringify(all));
)js";

/// Calls with each marked formula of the text, and gives the text with what it returns in its place.
template <class Replacement>
std::string with_formulas(const std::string& text, const Replacement& replacement) {
  std::string made;
  for (std::size_t at = 0;;) {
    const std::size_t begin = std::min(text.find(formula_begins, at), text.size());
    made.append(text, at, begin - at);
    if (begin == text.size()) return made;
    const std::size_t end = text.find(formula_ends, begin);
    made += replacement(text.substr(begin + 1, end - begin - 1));
    at = end + 1;
  }
}

/// Each formula typeset, or none where node or KaTeX is missing.
std::map<std::string, std::string> typeset_by_katex(const std::set<std::string>& formulas) {
  using nlohmann::json;
  const std::vector<std::string> list(formulas.begin(), formulas.end());
  if (list.empty() || !fs::exists("/usr/share/nodejs/katex")) return {};
  const PassingFolder folder;
  const fs::path out = folder / "formulas.json";
  try {
    const std::string input = json(list).dump(-1, ' ', true, json::error_handler_t::replace);
    const Ended ended =
        run_program({"node", "-e", typesetter, out.string()}, input, std::chrono::seconds(60));
    if (!ended.ok)
      throw BadInput("node, which typesets the site's formulas, ended by " + ended.how +
                     "; it takes a gigabyte of addresses");
  } catch (const std::system_error&) {
    return {};
  }
  std::ifstream file(out);
  const json answers = json::parse(file);
  std::map<std::string, std::string> made;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (answers.at(i).at(0).is_null())
      throw std::runtime_error("the formula $" + list[i] +
                               "$ cannot be typeset: " + answers.at(i).at(1).get<std::string>());
    made[list[i]] = answers.at(i).at(0).get<std::string>();
  }
  return made;
}

}  // namespace

std::string marked(std::string_view tex) {
  std::string text(1, formula_begins);
  for (char c : tex) text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return text + formula_ends;
}

bool typeset(std::map<std::string, std::string>& pages) {
  std::set<std::string> formulas;
  for (const auto& [name, text] : pages)
    with_formulas(text, [&](const std::string& tex) { return formulas.insert(tex), ""; });
  const auto made = typeset_by_katex(formulas);
  for (auto& [name, text] : pages)
    text = with_formulas(text, [&](const std::string& tex) {
      const auto known = made.find(tex);
      return known != made.end() ? known->second : element("code", " class=\"tex\"", in_xml(tex));
    });
  return !made.empty();
}

}  // namespace oddity::html
