//! The machine that a pickle without imports and calls runs on.

use std::collections::BTreeMap;

use super::COLOR;
use super::opcode::{self, Break, Opcode, unsigned};

/// A value by its place in the [`Heap`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Value(usize);

/// What a value is. Values inside of others are shared, never copied: a pickle can name one many
/// times.
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// `None`.
    None,
    /// A truth value or an integer; what does not fit is saturated.
    Integer(i64),
    /// A float.
    Float(f64),
    /// A text.
    Text(String),
    /// A tuple.
    Tuple(Vec<Value>),
    /// A list.
    List(Vec<Value>),
    /// A dictionary: keys with their values, the last of equal keys last.
    Dict(Vec<(Value, Value)>),
    /// The class of colours.
    Class,
    /// A colour: its members for red, green and blue, as far as they were set.
    Color([Option<Value>; 3]),
    /// Bytes, a set, or anything else that nobody asks for.
    Other,
}

/// All values of a pickle.
#[derive(Debug, Default)]
pub struct Heap(Vec<Node>);

/// Why the machine stops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// No instruction can be read.
    Break(Break),
    /// An instruction that does not find what it works on.
    Stack(&'static str),
    /// An argument that is no value of its kind.
    Argument(&'static str),
    /// An instruction that imports or calls: the machine has none of these.
    Refused(&'static str),
    /// A protocol that no Python has.
    Protocol(u8),
    /// More work than any file of its size is worth.
    Unbounded,
}

/// Names of the members of a colour.
const MEMBERS: [&str; 3] = ["_r", "_g", "_b"];
/// Values of one pickle at most: those of scenes have twenty.
const MOST_VALUES: usize = 1 << 18;
/// Members that all colours of a pickle are given at most: one dictionary can be given to many,
/// again and again.
const MOST_MEMBERS: usize = 1 << 20;

impl Heap {
    /// What a value is.
    pub fn get(&self, value: Value) -> &Node {
        self.0.get(value.0).unwrap_or(&Node::Other)
    }

    fn add(&mut self, node: Node) -> Value {
        self.0.push(node);
        Value(self.0.len() - 1)
    }
}

/// Runs the pickle that begins at `start` of a file; returns its value and where the next one
/// begins.
///
/// # Errors
/// Where the machine stops, and why.
pub fn run(bytes: &[u8], start: usize, heap: &mut Heap) -> Result<(Value, usize), (usize, Fault)> {
    let mut machine = Machine {
        heap,
        stack: Vec::new(),
        marks: Vec::new(),
        memo: BTreeMap::new(),
        members: 0,
    };
    let mut at = start;
    loop {
        let (own, next) = opcode::read(bytes, at).map_err(|fault| (at, Fault::Break(fault)))?;
        if own.name == "STOP" {
            return machine
                .pop(own.name)
                .map(|value| (value, next))
                .map_err(|fault| (at, fault));
        }
        machine.step(&own).map_err(|fault| (at, fault))?;
        if machine.is_full() {
            return Err((at, Fault::Unbounded));
        }
        at = next;
    }
}

struct Machine<'h> {
    heap: &'h mut Heap,
    stack: Vec<Value>,
    /// Heights of the stack at which a mark stands.
    marks: Vec<usize>,
    memo: BTreeMap<u64, Value>,
    /// Members that colours were given so far.
    members: usize,
}

impl Machine<'_> {
    /// Whether there are more values than any pickle of a scene has.
    fn is_full(&self) -> bool {
        self.heap
            .0
            .len()
            .max(self.stack.len())
            .max(self.marks.len())
            .max(self.memo.len())
            > MOST_VALUES
    }

    fn step(&mut self, own: &Opcode<'_>) -> Result<(), Fault> {
        match own.name {
            "MARK" => self.marks.push(self.stack.len()),
            "FRAME" => {}
            "PROTO" => return protocol(own.argument),
            "POP" if self.marks.last() == Some(&self.stack.len()) => {
                self.marks.pop();
            }
            "POP" => drop(self.pop(own.name)?),
            "POP_MARK" => drop(self.marked(own.name)?),
            "DUP" => self.stack.push(self.top(own.name)?),
            "PUT" | "BINPUT" | "LONG_BINPUT" | "MEMOIZE" => return self.memoize(own),
            "GET" | "BINGET" | "LONG_BINGET" => return self.recall(own),
            "APPEND" | "APPENDS" | "SETITEM" | "SETITEMS" | "ADDITEMS" | "BUILD" => {
                return self.change(own.name);
            }
            _ => {
                let node = self.node(own)?;
                let value = self.heap.add(node);
                self.stack.push(value);
            }
        }
        Ok(())
    }

    /// The value that an instruction makes.
    fn node(&mut self, own: &Opcode<'_>) -> Result<Node, Fault> {
        let bad = Fault::Argument(own.name);
        Ok(match own.name {
            "NONE" => Node::None,
            "NEWTRUE" => Node::Integer(1),
            "NEWFALSE" => Node::Integer(0),
            "BININT1" | "BININT2" => {
                Node::Integer(i64::try_from(unsigned(own.argument)).unwrap_or(i64::MAX))
            }
            "BININT" | "LONG1" | "LONG4" => Node::Integer(signed(own.argument)),
            "INT" | "LONG" => Node::Integer(integer(own.argument).ok_or(bad)?),
            "BINFLOAT" => Node::Float(f64::from_be_bytes(
                own.argument.try_into().map_err(|_| bad)?,
            )),
            "FLOAT" => Node::Float(
                text(own.argument)
                    .and_then(|text| text.trim().parse().ok())
                    .ok_or(bad)?,
            ),
            "STRING" => Node::Text(quoted(own.argument).ok_or(bad)?),
            "BINSTRING" | "SHORT_BINSTRING" => Node::Text(
                text(own.argument)
                    .filter(|text| text.is_ascii())
                    .ok_or(bad)?
                    .to_owned(),
            ),
            "UNICODE" | "BINUNICODE" | "BINUNICODE8" | "SHORT_BINUNICODE" => {
                Node::Text(text(own.argument).ok_or(bad)?.to_owned())
            }
            "EMPTY_TUPLE" => Node::Tuple(Vec::new()),
            "TUPLE1" => Node::Tuple(self.pop_many(1, own.name)?),
            "TUPLE2" => Node::Tuple(self.pop_many(2, own.name)?),
            "TUPLE3" => Node::Tuple(self.pop_many(3, own.name)?),
            "TUPLE" => Node::Tuple(self.marked(own.name)?),
            "EMPTY_LIST" => Node::List(Vec::new()),
            "LIST" => Node::List(self.marked(own.name)?),
            "EMPTY_DICT" => Node::Dict(Vec::new()),
            "DICT" => Node::Dict(pairs(&self.marked(own.name)?).ok_or(Fault::Stack(own.name))?),
            "FROZENSET" => {
                self.marked(own.name)?;
                Node::Other
            }
            "EMPTY_SET" | "BINBYTES" | "SHORT_BINBYTES" | "BINBYTES8" | "BYTEARRAY8" => Node::Other,
            "GLOBAL" if (own.argument, own.second) == (COLOR.0.as_bytes(), COLOR.1.as_bytes()) => {
                Node::Class
            }
            "NEWOBJ" => self.color()?,
            _ => return Err(Fault::Refused(own.name)),
        })
    }

    /// Below the last mark nothing can be reached.
    fn top(&self, name: &'static str) -> Result<Value, Fault> {
        let fence = self.marks.last().copied().unwrap_or_default();
        self.stack
            .get(fence..)
            .and_then(<[Value]>::last)
            .copied()
            .ok_or(Fault::Stack(name))
    }

    fn pop(&mut self, name: &'static str) -> Result<Value, Fault> {
        let top = self.top(name)?;
        self.stack.pop();
        Ok(top)
    }

    fn pop_many(&mut self, count: usize, name: &'static str) -> Result<Vec<Value>, Fault> {
        let mut values: Vec<Value> = (0..count)
            .map(|_| self.pop(name))
            .collect::<Result<_, _>>()?;
        values.reverse();
        Ok(values)
    }

    fn marked(&mut self, name: &'static str) -> Result<Vec<Value>, Fault> {
        let mark = self.marks.pop().ok_or(Fault::Stack(name))?;
        Ok(self.stack.split_off(mark.min(self.stack.len())))
    }

    fn memoize(&mut self, own: &Opcode<'_>) -> Result<(), Fault> {
        let place = self.place(own).ok_or(Fault::Argument(own.name))?;
        let top = self.top(own.name)?;
        self.memo.insert(place, top);
        Ok(())
    }

    fn recall(&mut self, own: &Opcode<'_>) -> Result<(), Fault> {
        let place = self.place(own).ok_or(Fault::Argument(own.name))?;
        let value = *self.memo.get(&place).ok_or(Fault::Argument(own.name))?;
        self.stack.push(value);
        Ok(())
    }

    fn place(&self, own: &Opcode<'_>) -> Option<u64> {
        match own.name {
            "MEMOIZE" => Some(self.memo.len() as u64),
            "PUT" | "GET" => text(own.argument)?.trim().parse().ok(),
            _ => Some(unsigned(own.argument)),
        }
    }

    /// A class and a tuple of arguments, which the class of colours does not look at.
    fn color(&mut self) -> Result<Node, Fault> {
        let (arguments, class) = (self.pop("NEWOBJ")?, self.pop("NEWOBJ")?);
        match (self.heap.get(class), self.heap.get(arguments)) {
            (Node::Class, Node::Tuple(_)) => Ok(Node::Color([None; 3])),
            _ => Err(Fault::Stack("NEWOBJ")),
        }
    }

    fn change(&mut self, name: &'static str) -> Result<(), Fault> {
        let fault = Fault::Stack(name);
        let values = match name {
            "APPEND" | "BUILD" => self.pop_many(1, name)?,
            "SETITEM" => self.pop_many(2, name)?,
            _ => self.marked(name)?,
        };
        let target = self.top(name)?;
        if name == "BUILD" {
            let [state] = *values.as_slice() else {
                return Err(fault);
            };
            return self.build(target, state);
        }
        if values.is_empty() {
            return Ok(());
        }
        match (name, self.heap.0.get_mut(target.0)) {
            ("APPEND" | "APPENDS", Some(Node::List(own))) => own.extend(values),
            ("SETITEM" | "SETITEMS", Some(Node::Dict(own))) => {
                own.extend(pairs(&values).ok_or(fault)?);
            }
            ("ADDITEMS", Some(Node::Other)) => {}
            _ => return Err(fault),
        }
        Ok(())
    }

    /// Of all values only colours have members to set.
    fn build(&mut self, target: Value, state: Value) -> Result<(), Fault> {
        let members: &[(Value, Value)] = match self.heap.get(state) {
            Node::None => &[],
            Node::Dict(members) => members,
            _ => return Err(Fault::Stack("BUILD")),
        };
        self.members += members.len();
        if self.members > MOST_MEMBERS {
            return Err(Fault::Unbounded);
        }
        let is_key =
            |key: Value, name: &str| matches!(self.heap.get(key), Node::Text(text) if text == name);
        let set = MEMBERS.map(|name| {
            members
                .iter()
                .rev()
                .find(|(key, _)| is_key(*key, name))
                .map(|(_, value)| *value)
        });
        let Some(Node::Color(own)) = self.heap.0.get_mut(target.0) else {
            return Err(Fault::Stack("BUILD"));
        };
        for (own, new) in own.iter_mut().zip(set) {
            *own = new.or(*own);
        }
        Ok(())
    }
}

fn protocol(argument: &[u8]) -> Result<(), Fault> {
    argument
        .first()
        .filter(|own| **own > 5)
        .map_or(Ok(()), |own| Err(Fault::Protocol(*own)))
}

fn pairs(values: &[Value]) -> Option<Vec<(Value, Value)>> {
    let (pairs, rest) = values.as_chunks::<2>();
    rest.is_empty()
        .then(|| pairs.iter().map(|[key, value]| (*key, *value)).collect())
}

fn text(bytes: &[u8]) -> Option<&str> {
    std::str::from_utf8(bytes).ok()
}

/// Two's complement, the lowest byte first. Beyond eight bytes only the sign is kept.
fn signed(bytes: &[u8]) -> i64 {
    let is_negative = bytes.last().is_some_and(|last| *last > 0x7f);
    match bytes.len() {
        9.. => {
            if is_negative {
                i64::MIN
            } else {
                i64::MAX
            }
        }
        length => {
            let unused = 64 - 8 * u32::try_from(length).unwrap_or(8);
            if unused == 64 {
                0
            } else {
                (unsigned(bytes) << unused).cast_signed() >> unused
            }
        }
    }
}

/// An integer as protocol 0 writes it, with or without `L`.
fn integer(bytes: &[u8]) -> Option<i64> {
    let text = text(bytes)?.trim();
    text.strip_suffix('L').unwrap_or(text).parse().ok()
}

/// A text in quotes. What is escaped in it stays as it is: nobody asks for such a text.
fn quoted(bytes: &[u8]) -> Option<String> {
    let text = text(bytes)?.trim_end();
    let inner = ['\'', '"']
        .into_iter()
        .find_map(|quote| text.strip_prefix(quote)?.strip_suffix(quote))?;
    Some(inner.to_owned())
}
