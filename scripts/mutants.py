"""Every way to break one thing in a module's source, and one source that has them all.

The source with all mutants (a schema) is compiled once; a variable of each instance, taken from RC2_MUTANT in the
environment when the simulation begins, says which mutant is in force (0: none).

Mutated are right-hand sides, conditions of `if` and inputs of instances: an operator for its neighbour, a constant one
up or down, a negation or a complement left out, a condition turned round; and registers that are not written. Left
alone are contracts (assertions), and what is worked out when the design is built: parameters, generate loops, functions.
"""

import collections
import re

Token = collections.namedtuple("Token", "text start end")
Mutant = collections.namedtuple("Mutant", "number unit line before after")  # before, after: the statement
TOKEN = re.compile(r"(?P<skip>\s+|//[^\n]*|/\*.*?\*/)|\d*'s?[bdh][0-9a-fA-F_]+|'[01]|\d+|[A-Za-z_$][\w$]*|"
                   r"<<|>>|<=|>=|==|!=|&&|\|\||\+:|-:|::|.", re.DOTALL)
SWAPS = {"+": "-", "-": "+", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
         "&": "|", "|": "&", "^": "&", "<<": ">>", ">>": "<<"}
CHOICE = r'$c32("std::getenv(\"RC2_MUTANT\") == nullptr ? 0 : std::atoi(std::getenv(\"RC2_MUTANT\"))")'
OPERAND_ENDS = re.compile(r"[\w$')\]}]")  # a binary operator stands after one


def tokens_of(text):
    return [Token(m[0], *m.span()) for m in TOKEN.finditer(text) if not m["skip"]]


def other_constants(text, in_index):
    """A constant one up and one down. In an index only the one that is surely there."""
    if text in ("'0", "'1"):
        return ["'1" if text == "'0" else "'0"]
    width, base, digits = re.fullmatch(r"(?:(\d*)'s?([bdh]))?([0-9a-fA-F_]+)", text).groups()
    radix = {"b": 2, "h": 16}.get(base, 10)
    value = int(digits.replace("_", ""), radix)
    if in_index:
        values = [value - 1 if value else 1]
    else:
        top = 1 << int(width) if width else None
        values = [v for v in (value + 1, value - 1) if v >= 0 and (top is None or v < top)]
    shown = {2: "{:b}", 16: "{:x}", 10: "{}"}[radix]
    return [(f"{width}'{base}" if base else "") + shown.format(v) for v in values]


class Source:
    """A module's source, its mutants and its schema."""

    def __init__(self, unit, text, first):
        self.unit, self.text, self.next = unit, text, first
        contract = text.find("// Contract")
        self.tokens = tokens_of(text if contract < 0 else text[:contract])
        self.mutants, self.edits, self.at = [], [], 0
        while self.here() != "module":
            self.at += 1
        while self.here() != ";":
            self.at += 1
        self.edits.append((self.tokens[self.at].end, self.tokens[self.at].end,
                           '\n  int unsigned mutant;\n  initial mutant = ' + CHOICE + ";\n"))
        self.at += 1
        while self.at < len(self.tokens) and self.here() != "endmodule":
            self.item()

    def schema(self):
        text = self.text
        for start, end, new in sorted(self.edits, reverse=True):
            text = text[:start] + new + text[end:]
        return text

    # ---- Tokens ----------------------------------------------------------------------------------
    def here(self):
        return self.tokens[self.at].text if self.at < len(self.tokens) else ""

    def past(self, *ends):
        """Moves on to one of `ends` outside all brackets; returns the tokens before it."""
        first, depth = self.at, 0
        while self.at < len(self.tokens) and (depth or self.here() not in ends):
            depth += (self.here() in "([{") - (self.here() in ")]}")
            self.at += 1
        return first, self.at

    def brackets(self):
        """At an opening bracket: the tokens within; moves on behind the closing one."""
        self.at += 1
        inside = self.past(")")
        self.at += 1
        return inside

    def words(self, first, last):
        return self.text[self.tokens[first].start:self.tokens[last - 1].end] if last > first else ""

    # ---- The grammar, as far as it is needed -----------------------------------------------------
    def item(self):
        word = self.here()
        if word == "assign":
            first = self.at
            self.past("=")
            self.at += 1
            self.expression(*self.past(";"), first)
            self.at += 1
        elif word in ("always_ff", "always_comb"):
            self.at += 1
            if self.here() == "@":
                self.at += 1
                self.brackets()
            self.statement()
        elif word in ("for", "if"):  # worked out when the design is built
            self.at += 1
            self.brackets()
            self.block(self.item)
            if self.here() == "else":
                self.at += 1
                if self.here() == "if":
                    self.item()
                else:
                    self.block(self.item)
        elif word == "function":
            while self.here() != "endfunction":
                self.at += 1
            self.at += 1
        elif word.startswith("rc2_") and self.tokens[self.at + 1].text != "::":
            self.instance()
        else:
            self.past(";")
            self.at += 1

    def block(self, inner):
        if self.here() != "begin":
            inner()
            return
        self.at += 1
        if self.here() == ":":
            self.at += 2
        while self.at < len(self.tokens) and self.here() != "end":
            inner()
        self.at += 1

    def instance(self):
        while self.here() != "(" or self.tokens[self.at - 1].text == "#":
            if self.here() == "(":
                self.brackets()
            else:
                self.at += 1
        self.at += 1
        while self.here() != ")":
            first = self.at
            self.past("(")
            self.at += 1
            inside = self.past(")")
            self.at += 1
            if self.tokens[first + 1].text.endswith("_i"):
                self.expression(*inside, first, self.at)
            self.at += self.here() == ","
        self.at += 2

    def statement(self):
        word = self.here()
        if word == "begin":
            self.block(self.statement)
        elif word == "if":
            first = self.at
            self.at += 1
            inside = self.brackets()
            self.expression(*inside, first, self.at, condition=True)
            self.statement()
            if self.here() == "else":
                self.at += 1
                self.statement()
        elif word == "for":
            self.at += 1
            self.brackets()
            self.statement()
        elif word == "case":
            self.at += 1
            self.brackets()
            while self.here() != "endcase":
                self.past(":")
                self.at += 1
                self.statement()
            self.at += 1
        elif word == ";":
            self.at += 1
        else:
            first = self.at
            self.past("=", "<=")
            register = self.here() == "<="
            self.at += 1
            self.expression(*self.past(";"), first)
            self.at += 1
            if register:
                number = self.add(first, self.at, "(not written)")
                self.edits.append((self.tokens[first].start, self.tokens[first].start, f"begin if (mutant != {number}) "))
                self.edits.append((self.tokens[self.at - 1].end, self.tokens[self.at - 1].end, " end"))

    # ---- Mutants -----------------------------------------------------------------------------------
    def add(self, first, last, after):
        line = self.text.count("\n", 0, self.tokens[first].start) + 1
        squeeze = lambda text: " ".join(text.split())
        self.mutants.append(Mutant(self.next, self.unit, line, squeeze(self.words(first, last)), squeeze(after)))
        self.next += 1
        return self.next - 1

    def expression(self, first, last, statement, end=None, condition=False):
        """Mutates the tokens first .. last of the statement that goes from `statement` to `end`."""
        end = end or last
        if first == last:
            return
        start, stop = self.tokens[first].start, self.tokens[last - 1].end
        before, behind = self.text[self.tokens[statement].start:start], self.text[stop:self.tokens[end - 1].end] if end > last else ""
        choice = ""
        for expression in self.variants(first, last, condition):
            number = self.add(statement, end, before + expression + behind)
            choice += f"(mutant == {number}) ? ({expression}) : "
        if choice:
            self.edits.append((start, stop, f"{choice}({self.text[start:stop]})"))

    def variants(self, first, last, condition):
        start, stop = self.tokens[first].start, self.tokens[last - 1].end
        whole = self.text[start:stop]

        def changed(low, high, new):
            return whole[:low - start] + new + whole[high - start:]

        # A condition of one comparison or negation is turned round by what follows.
        texts = [token.text for token in self.tokens[first:last]]
        if condition and ("&&" in texts or "||" in texts or not {"!", "==", "!=", "<", ">", "<=", ">="} & set(texts)):
            yield f"!({whole})"
        brackets = []
        for i in range(first, last):
            token, before = self.tokens[i], self.tokens[i - 1].text
            binary = i > first and OPERAND_ENDS.match(before[-1]) and before not in ("return",)
            if token.text in "([{":
                brackets.append(token.text)
            elif token.text in ")]}":
                brackets.pop()
            elif "[" in brackets and (before, self.tokens[i + 1].text) != ("[", "]"):
                continue  # what is reckoned in an index is where a slice or a word ends: mostly not there
            elif token.text in SWAPS and (binary or token.text in "&|"):
                yield changed(token.start, token.end, SWAPS[token.text])
            elif token.text in ("!", "~", "-") and not binary:
                yield changed(token.start, token.end, "")
            elif token.text == "?":
                low = self.condition_start(i, first)
                yield changed(self.tokens[low].start, token.start, f"!({self.words(low, i)}) ")
            elif re.match(r"\d|'[01]", token.text) and before != "'" and self.tokens[i + 1].text != "'":
                if brackets and brackets[-1] == "{" and self.tokens[i + 1].text == "{":
                    continue  # a count of copies
                for constant in other_constants(token.text, "[" in brackets):
                    yield changed(token.start, token.end, constant)

    def condition_start(self, i, first):
        depth = 0
        while i > first:
            before = self.tokens[i - 1].text
            if not depth and before in ("(", "[", "{", ",", "?", ":"):
                break
            depth += (before in ")]}") - (before in "([{")
            i -= 1
        return i
