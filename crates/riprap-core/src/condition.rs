//! Conditions on blocks: what `and`, `or`, `not` and parentheses make of names, for example `roof and not (ore or 'left wall')`.

use std::fmt;
use std::ops::Range;

/// Parentheses and `not` within each other that are read.
const DEEPEST: usize = 100;

/// A word of a condition and its place in the text, bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// The word, without quotes.
    pub text: String,
    /// Where it stands, with its quotes.
    pub at: Range<usize>,
    /// Whether it stands in quotes: a name, whatever it is.
    quoted: bool,
}

impl Word {
    fn is(&self, sign: &str) -> bool {
        !self.quoted && self.text == sign
    }

    fn is_sign(&self) -> bool {
        ["and", "or", "not", "(", ")"].iter().any(|sign| self.is(sign))
    }
}

/// What is wrong with a condition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Where in the text, bytes.
    pub at: Range<usize>,
    /// What is wrong.
    pub why: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.why)
    }
}

/// Names by their number among those of the condition.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Node {
    Name(usize),
    Not(Box<Node>),
    All(Vec<Node>),
    Any(Vec<Node>),
}

impl Node {
    fn holds(&self, of: &dyn Fn(usize) -> bool) -> bool {
        match self {
            Self::Name(k) => of(*k),
            Self::Not(one) => !one.holds(of),
            Self::All(all) => all.iter().all(|one| one.holds(of)),
            Self::Any(any) => any.iter().any(|one| one.holds(of)),
        }
    }
}

/// A condition: `not` binds before `and`, and `and` before `or`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    /// Names in the order in which they stand, each as often as it does.
    pub names: Vec<Word>,
    root: Node,
}

impl Condition {
    /// Whether a text is meant as a condition: a name with blanks is none.
    #[must_use]
    pub fn is_meant(text: &str) -> bool {
        words(text).iter().any(Word::is_sign)
    }

    /// Reads a condition.
    ///
    /// # Errors
    /// What is wrong, at its place.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap_core::condition::Condition;
    ///
    /// let condition = Condition::read("roof and not (ore or 'left wall')")?;
    /// let of = ["roof", "left wall"];
    /// assert!(!condition.holds(&|name| of.contains(&name)));
    /// assert!(condition.holds(&|name| name == "roof"));
    /// assert_eq!(Condition::read("roof and and ore").unwrap_err().at, 9..12);
    /// # Ok::<(), riprap_core::condition::Fault>(())
    /// ```
    pub fn read(text: &str) -> Result<Self, Fault> {
        let words = words(text);
        let mut reader = Reader { words: &words, at: 0, end: text.len(), names: Vec::new() };
        let root = reader.any(0)?;
        match reader.words.get(reader.at) {
            None => Ok(Self { names: reader.names, root }),
            Some(more) => Err(Fault {
                at: more.at.clone(),
                why: format!("`{}` is not expected here", more.text),
            }),
        }
    }

    /// The condition of one name, whatever stands in it.
    #[must_use]
    pub fn name(text: &str) -> Self {
        let word = Word { text: text.to_owned(), at: 0..text.len(), quoted: true };
        Self { names: vec![word], root: Node::Name(0) }
    }

    /// Whether it holds for something of which a name may hold.
    #[must_use]
    pub fn holds(&self, of: &dyn Fn(&str) -> bool) -> bool {
        self.holds_by(&|k| of(&self.names[k].text))
    }

    /// Whether it holds for something of which a name may hold, by the number of the name.
    #[must_use]
    pub fn holds_by(&self, of: &dyn Fn(usize) -> bool) -> bool {
        self.root.holds(of)
    }
}

/// Words and parentheses of a text; what stands in single quotes is one word.
fn words(text: &str) -> Vec<Word> {
    let mut all: Vec<Word> = Vec::new();
    let mut open: Option<Word> = None;
    let mut in_quotes = false;
    for (k, c) in text.char_indices() {
        let after = k + c.len_utf8();
        if c == '\'' {
            let word = open.get_or_insert(Word { text: String::new(), at: k..k, quoted: true });
            word.quoted = true;
            word.at.end = after;
            in_quotes = !in_quotes;
        } else if !in_quotes && (c.is_whitespace() || c == '(' || c == ')') {
            all.extend(open.take());
            if !c.is_whitespace() {
                all.push(Word { text: c.to_string(), at: k..after, quoted: false });
            }
        } else {
            let word = open.get_or_insert(Word { text: String::new(), at: k..k, quoted: false });
            word.text.push(c);
            word.at.end = after;
        }
    }
    all.extend(open);
    all
}

/// Reads `or` of `and` of what may be negated.
struct Reader<'a> {
    words: &'a [Word],
    at: usize,
    /// Length of the text, bytes.
    end: usize,
    names: Vec<Word>,
}

impl Reader<'_> {
    fn take(&mut self, sign: &str) -> bool {
        let is = self.words.get(self.at).is_some_and(|word| word.is(sign));
        self.at += usize::from(is);
        is
    }

    fn any(&mut self, depth: usize) -> Result<Node, Fault> {
        let mut list = vec![self.all(depth)?];
        while self.take("or") {
            list.push(self.all(depth)?);
        }
        Ok(Node::Any(list))
    }

    fn all(&mut self, depth: usize) -> Result<Node, Fault> {
        let mut list = vec![self.one(depth)?];
        while self.take("and") {
            list.push(self.one(depth)?);
        }
        Ok(Node::All(list))
    }

    fn one(&mut self, depth: usize) -> Result<Node, Fault> {
        let here = self.words.get(self.at);
        let at = here.map_or(self.end..self.end, |word| word.at.clone());
        if depth > DEEPEST {
            let why = format!("more than {DEEPEST} parentheses and `not` within each other");
            return Err(Fault { at, why });
        }
        if self.take("not") {
            return Ok(Node::Not(Box::new(self.one(depth + 1)?)));
        }
        if self.take("(") {
            let inner = self.any(depth + 1)?;
            return if self.take(")") {
                Ok(inner)
            } else {
                Err(Fault { at, why: "a parenthesis is not closed".to_owned() })
            };
        }
        match here.filter(|word| !word.is_sign()) {
            Some(word) => {
                self.at += 1;
                self.names.push(word.clone());
                Ok(Node::Name(self.names.len() - 1))
            }
            None => Err(Fault { at, why: "a name is missing".to_owned() }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Condition, DEEPEST};

    /// Whether a condition holds for what is in `a` and in `b`, in one of them, or in none.
    fn table(text: &str) -> [bool; 4] {
        let condition = Condition::read(text).expect(text);
        [(true, true), (true, false), (false, true), (false, false)].map(|(a, b)| {
            condition.holds(&|name| match name {
                "a" => a,
                "b" | "b c" => b,
                other => panic!("{other}"),
            })
        })
    }

    #[test]
    fn not_binds_before_and_and_and_before_or() {
        assert_eq!(table("a and not b"), [false, true, false, false]);
        assert_eq!(table("not a or b"), [true, false, true, true]);
        assert_eq!(table("not (a or 'b c')"), [false, false, false, true]);
        assert_eq!(table("a or b and a"), [true, true, false, false]);
        assert_eq!(table("(a or b)and not(a and b)"), [false, true, true, false]);
    }

    #[test]
    fn a_fault_is_at_its_word() {
        let at = |text: &str| {
            let fault = Condition::read(text).expect_err(text);
            (text[fault.at].to_owned(), fault.why)
        };
        assert_eq!(at("a and"), (String::new(), "a name is missing".to_owned()));
        assert_eq!(at("a or or b").0, "or");
        assert_eq!(at("a (b)"), ("(".to_owned(), "`(` is not expected here".to_owned()));
        assert_eq!(at("a b").0, "b");
        assert_eq!(at("é and (b or a").1, "a parenthesis is not closed");
        assert_eq!(at("").1, "a name is missing");
        let deep = "(".repeat(10 * DEEPEST) + "a";
        assert!(Condition::read(&deep).is_err_and(|fault| fault.why.starts_with("more than")));
    }

    #[test]
    fn a_name_with_blanks_is_no_condition() {
        assert!(!Condition::is_meant("left wall") && !Condition::is_meant("candor"));
        assert!(!Condition::is_meant("'and'") && Condition::is_meant("not a"));
        assert!(Condition::is_meant("(a)"));
    }
}
