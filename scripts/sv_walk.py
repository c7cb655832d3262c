"""A walk through a module's SystemVerilog, as far as breaking it needs.

Knows the subset that rtl/ is written in; meets assignments, conditions of `if` and inputs of instances, each
once. Passes over contracts (assertions) and what is worked out when the design is built: parameters,
generate loops, functions.
"""

import collections
import re

Token = collections.namedtuple("Token", "text start end")
TOKEN = re.compile(r"(?P<skip>\s+|//[^\n]*|/\*.*?\*/)|\d*'s?[bdh][0-9a-fA-F_]+|'[01]|\d+|[A-Za-z_$][\w$]*|"
                   r"<<<|>>>|<<|>>|<=|>=|==|!=|&&|\|\||\+:|-:|::|.", re.DOTALL)


class Walk:
    """Places are numbers of tokens. Inherit and say what happens at them."""

    def __init__(self, text):
        contract = text.find("// Contract")
        text = text if contract < 0 else text[:contract]
        self.text = text
        self.tokens = [Token(m[0], *m.span()) for m in TOKEN.finditer(text) if not m["skip"]]
        self.at = 0

    def meet_header(self, end):
        """The module's header ends before `end`."""

    def meet_expression(self, first, last, statement, end, condition):
        """first .. last of the statement that goes from `statement` to `end`."""

    def meet_register(self, first, last):
        """A register is written by first .. last."""

    def walk(self):
        while self.here() != "module":
            self.at += 1
        self.past(";")
        self.at += 1
        self.meet_header(self.at)
        while self.at < len(self.tokens) and self.here() != "endmodule":
            self.item()

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
            self.meet_expression(*self.past(";"), first, self.at, False)
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
                self.meet_expression(*inside, first, self.at, False)
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
            self.meet_expression(*inside, first, self.at, True)
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
            self.meet_expression(*self.past(";"), first, self.at, False)
            self.at += 1
            if register:
                self.meet_register(first, self.at)
