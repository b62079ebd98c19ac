//! The text of a formula to the program that finds its value.
//!
//! ```text
//! formula  := sum [("<" | "<=" | ">" | ">=" | "==" | "!=") sum]
//! sum      := signed with + - * / between
//! signed   := ("-" | "+") signed | power
//! power    := primary ["^" signed]
//! primary  := number | name | function "(" formula {"," formula} ")" | "(" formula ")"
//! ```
//!
//! `-` binds tighter than `+` and `/` tighter than `*`: the same number but for round-off, `a*b/c` being `a*(b/c)`.

use super::{FormulaError, MAX_DEPTH, MAX_LENGTH, Op, Program};

/// What a function does with its arguments.
enum Function {
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
    /// Two or more, taken together from the left.
    Many(fn(f64, f64) -> f64),
    If,
}

/// The functions of `libm`, whose bits are the same on every machine; what is taken from the platform is exact.
fn function(name: &str) -> Option<Function> {
    Some(match name {
        "sin" => Function::One(libm::sin),
        "cos" => Function::One(libm::cos),
        "tan" => Function::One(libm::tan),
        "asin" => Function::One(libm::asin),
        "acos" => Function::One(libm::acos),
        "atan" => Function::One(libm::atan),
        "sinh" => Function::One(libm::sinh),
        "cosh" => Function::One(libm::cosh),
        "tanh" => Function::One(libm::tanh),
        "asinh" => Function::One(libm::asinh),
        "acosh" => Function::One(libm::acosh),
        "atanh" => Function::One(libm::atanh),
        "exp" => Function::One(libm::exp),
        "ln" | "log" => Function::One(libm::log),
        "log2" => Function::One(libm::log2),
        "log10" => Function::One(libm::log10),
        "sqrt" => Function::One(f64::sqrt),
        "cbrt" => Function::One(libm::cbrt),
        "abs" => Function::One(f64::abs),
        "sign" | "signum" => Function::One(sign),
        "floor" => Function::One(f64::floor),
        "ceil" => Function::One(f64::ceil),
        "round" => Function::One(f64::round),
        "trunc" => Function::One(f64::trunc),
        "fract" => Function::One(f64::fract),
        "atan2" => Function::Two(libm::atan2),
        "min" => Function::Many(smaller),
        "max" => Function::Many(larger),
        "if" => Function::If,
        _ => return None,
    })
}

/// The smaller of two numbers; NaN if one of them is: a number that does not exist must not vanish.
fn smaller(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.min(b) }
}

/// The larger of two numbers; NaN if one of them is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// -1, 0 or 1; NaN of NaN.
fn sign(x: f64) -> f64 {
    // `signum` of 0 is 1.
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// One for true, zero for false, NaN if one side is.
fn truth(a: f64, b: f64, holds: bool) -> f64 {
    match (a.is_nan() || b.is_nan(), holds) {
        (true, _) => f64::NAN,
        (false, true) => 1.0,
        (false, false) => 0.0,
    }
}

/// What `if` takes.
const BRANCH: &str = "three arguments: condition, value, other value";

/// What an operator does with the numbers on both sides.
type Operation = fn(f64, f64) -> f64;

// Longer words first: `<` would be taken for the whole of `<=`.
const COMPARISONS: [(&str, Operation); 6] = [
    ("<=", |a, b| truth(a, b, a <= b)),
    (">=", |a, b| truth(a, b, a >= b)),
    ("==", |a, b| truth(a, b, a == b)),
    ("!=", |a, b| truth(a, b, a != b)),
    ("<", |a, b| truth(a, b, a < b)),
    (">", |a, b| truth(a, b, a > b)),
];

/// Operators between terms: how tight they bind, and what they do.
const OPERATORS: [(char, u8, Operation); 4] = [
    ('+', 0, |a, b| a + b),
    ('-', 1, |a, b| a - b),
    ('*', 2, |a, b| a * b),
    ('/', 3, |a, b| a / b),
];

/// Compiles a text.
///
/// # Errors
/// What is wrong with it, and where.
pub(super) fn parse(text: &str) -> Result<Program, FormulaError> {
    if text.len() > MAX_LENGTH {
        return Err(FormulaError::TooLarge);
    }
    let mut parser = Parser { text, at: 0, depth: 0, program: Program::default() };
    parser.formula()?;
    match parser.peek() {
        None => Ok(parser.program),
        Some(')') => Err(parser.wrong("this parenthesis has no opening one")),
        Some(',') => {
            Err(parser.wrong("a comma is only allowed between the arguments of a function"))
        }
        Some('=') => Err(parser.wrong("to compare, write ==")),
        Some(c) if c.is_alphanumeric() || c == '(' || c == '.' => {
            Err(parser.wrong("an operator is missing before this"))
        }
        Some(c) => Err(parser.wrong(&format!("unexpected `{c}`"))),
    }
}

struct Parser<'a> {
    text: &'a str,
    /// Bytes read.
    at: usize,
    depth: usize,
    program: Program,
}

impl Parser<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or_default()
    }

    /// The next character that is no space.
    fn peek(&mut self) -> Option<char> {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
        self.rest().chars().next()
    }

    /// Reads `word` if it comes next.
    fn take(&mut self, word: &str) -> bool {
        let found = self.peek().is_some() && self.rest().starts_with(word);
        if found {
            self.at += word.len();
        }
        found
    }

    fn wrong(&self, message: &str) -> FormulaError {
        FormulaError::Syntax { at: self.at, message: message.to_owned() }
    }

    fn emit(&mut self, op: Op) -> usize {
        self.program.ops.push(op);
        self.program.ops.len() - 1
    }

    /// Goes one level down: parsing calls itself, and a text must not decide how deep.
    fn deeper<T>(
        &mut self,
        inner: impl FnOnce(&mut Self) -> Result<T, FormulaError>,
    ) -> Result<T, FormulaError> {
        if self.depth >= MAX_DEPTH {
            return Err(FormulaError::TooLarge);
        }
        self.depth += 1;
        let found = inner(self);
        self.depth -= 1;
        found
    }

    fn formula(&mut self) -> Result<(), FormulaError> {
        self.sum(0)?;
        if let Some(compare) = self.comparison() {
            self.sum(0)?;
            self.emit(Op::Two(compare));
            let before = self.at;
            if self.comparison().is_some() {
                self.at = before;
                return Err(self.wrong("compare two values at a time: (a < b)*(b < c)"));
            }
        }
        Ok(())
    }

    fn comparison(&mut self) -> Option<fn(f64, f64) -> f64> {
        let found = COMPARISONS.iter().find(|(word, _)| self.take(word));
        found.map(|(_, compare)| *compare)
    }

    /// Terms joined by operators that bind at least as tight as `least`.
    fn sum(&mut self, least: u8) -> Result<(), FormulaError> {
        self.signed()?;
        while let Some(next) = self.peek() {
            let found = OPERATORS.iter().find(|(sign, ..)| *sign == next);
            let Some((sign, tight, apply)) = found.filter(|(_, tight, _)| *tight >= least) else {
                break;
            };
            self.at += sign.len_utf8();
            // Operators of one kind go from the left: what comes behind this one has to bind tighter.
            self.sum(tight + 1)?;
            self.emit(Op::Two(*apply));
        }
        Ok(())
    }

    fn signed(&mut self) -> Result<(), FormulaError> {
        if self.take("-") {
            self.deeper(Self::signed)?;
            self.emit(Op::One(|x| -x));
            return Ok(());
        }
        if self.take("+") {
            return self.deeper(Self::signed);
        }
        self.primary()?;
        if self.take("^") {
            // What stands above can have a sign and a power of its own: `2^-1`, and `2^3^2` from the right.
            self.deeper(Self::signed)?;
            self.emit(Op::Two(libm::pow));
        }
        Ok(())
    }

    fn primary(&mut self) -> Result<(), FormulaError> {
        match self.peek() {
            Some('(') => {
                self.at += 1;
                self.deeper(Self::formula)?;
                self.close()
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => self.word(),
            Some(_) => Err(self.wrong("a number, a name or a parenthesis is missing here")),
            None => Err(self.wrong("unexpected end: a number or a name is missing")),
        }
    }

    fn close(&mut self) -> Result<(), FormulaError> {
        if self.take(")") {
            return Ok(());
        }
        Err(match self.peek() {
            None => self.wrong("a parenthesis is not closed"),
            Some('=') => self.wrong("to compare, write =="),
            Some(',') => self.wrong("one argument too many, or a function is missing"),
            Some(_) => self.wrong("an operator or a closing parenthesis is missing before this"),
        })
    }

    /// A number such as `2`, `0.5`, `.5`, `4e-3`.
    fn number(&mut self) -> Result<(), FormulaError> {
        let rest = self.rest();
        let count = |from: &str, of: fn(&char) -> bool| -> usize {
            from.chars().take_while(of).map(char::len_utf8).sum()
        };
        let digits: fn(&char) -> bool = char::is_ascii_digit;
        let mut length = count(rest, |c| c.is_ascii_digit() || *c == '.');
        let after = rest.get(length..).unwrap_or_default();
        if let Some(power) = after.strip_prefix(['e', 'E']) {
            let sign = usize::from(power.starts_with(['+', '-']));
            let figures = count(power.get(sign..).unwrap_or_default(), digits);
            // Without figures the `e` begins a name, and an operator is missing before it.
            if figures > 0 {
                length += 1 + sign + figures;
            }
        }
        let number = rest.get(..length).unwrap_or_default();
        match number.parse::<f64>() {
            Ok(value) if value.is_finite() => {
                self.at += length;
                self.emit(Op::Number(value));
                Ok(())
            }
            Ok(_) => Err(self.wrong("this number is too large")),
            Err(_) => Err(self.wrong(&format!("`{number}` is not a number"))),
        }
    }

    /// A name, or a function with its arguments.
    fn word(&mut self) -> Result<(), FormulaError> {
        let begun = self.at;
        let part = |c: &char| c.is_alphanumeric() || *c == '_';
        let rest = self.rest();
        let length = rest.chars().take_while(part).map(char::len_utf8).sum();
        let name = rest.get(..length).unwrap_or_default().to_owned();
        self.at += length;
        let called = self.take("(");
        match function(&name) {
            Some(function) if called => self.deeper(|inner| inner.call(&function, &name, begun)),
            Some(_) => {
                self.at = begun;
                Err(self.wrong(&format!("`{name}` is a function: write {name}(...)")))
            }
            None if called => {
                self.at = begun;
                Err(self.wrong(&format!("`{name}` is not a function")))
            }
            None => {
                let names = &mut self.program.names;
                let index = names.iter().position(|(known, _)| *known == name);
                let index = index.unwrap_or_else(|| {
                    names.push((name, begun));
                    names.len() - 1
                });
                self.emit(Op::Name(index));
                Ok(())
            }
        }
    }

    /// The arguments of a function, what it does with them, and its end.
    fn call(&mut self, function: &Function, name: &str, begun: usize) -> Result<(), FormulaError> {
        self.formula()?;
        if let Function::If = function {
            return self.branch(begun);
        }
        let mut given = 1;
        while self.take(",") {
            self.formula()?;
            given += 1;
            if let Function::Many(apply) = function {
                self.emit(Op::Two(*apply));
            }
        }
        let (wanted, fits) = match function {
            Function::One(apply) => {
                self.emit(Op::One(*apply));
                ("one argument", given == 1)
            }
            Function::Two(apply) => {
                self.emit(Op::Two(*apply));
                ("two arguments", given == 2)
            }
            Function::Many(_) => ("two or more arguments", given > 1),
            Function::If => (BRANCH, true),
        };
        if !fits {
            return Err(self.arguments(name, wanted, begun));
        }
        self.close()
    }

    /// `if(condition, then, otherwise)` behind its condition: only the side that counts is found.
    fn branch(&mut self, begun: usize) -> Result<(), FormulaError> {
        let missing = |parser: &mut Self| parser.arguments("if", BRANCH, begun);
        // Where it leads is known when both sides have been read.
        let branch = self.emit(Op::Branch { otherwise: 0, end: 0 });
        if !self.take(",") {
            return Err(missing(self));
        }
        self.formula()?;
        let jump = self.emit(Op::Jump(0));
        if !self.take(",") {
            return Err(missing(self));
        }
        self.formula()?;
        if self.peek() == Some(',') {
            return Err(missing(self));
        }
        let end = self.program.ops.len();
        self.program.ops[jump] = Op::Jump(end);
        self.program.ops[branch] = Op::Branch { otherwise: jump + 1, end };
        self.close()
    }

    fn arguments(&mut self, name: &str, wanted: &str, begun: usize) -> FormulaError {
        self.at = begun;
        self.wrong(&format!("`{name}` takes {wanted}"))
    }
}
