//! One pickle walked to its end, with everything in it that imports or calls.

use std::collections::BTreeMap;

use super::opcode::{self, Break, Opcode, unsigned};

/// An instruction that may run code of a stranger.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Danger {
    /// Where it stands in the file.
    pub offset: usize,
    /// Its name.
    pub opcode: &'static str,
    /// What it imports, as `module.name`, as far as that is written there.
    pub import: Option<String>,
}

/// A walk to the end of a pickle.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Walk {
    /// What was found on the way.
    pub dangers: Vec<Danger>,
    /// Where the pickle ends, or why it does not.
    pub end: Result<usize, (usize, Break)>,
}

/// Walks the pickle that begins at `start`. `is_known` says of a module and a name whether it may
/// be imported; calls of nothing but such are reported if `may_call` is not set.
pub fn walk(bytes: &[u8], start: usize, is_known: fn(&str, &str) -> bool, may_call: bool) -> Walk {
    let (mut dangers, mut at) = (Vec::new(), start);
    let mut texts = Texts::default();
    loop {
        let (own, next) = match opcode::read(bytes, at) {
            Ok(read) => read,
            Err(fault) => {
                return Walk {
                    dangers,
                    end: Err((at, fault)),
                };
            }
        };
        let import = match own.name {
            "GLOBAL" | "INST" => Some((lossy(own.argument), lossy(own.second))),
            "STACK_GLOBAL" => Some(texts.last_two()),
            _ => None,
        };
        let is_stranger = import
            .as_ref()
            .is_some_and(|(module, name)| !is_known(module, name));
        let is_call = matches!(
            own.name,
            "REDUCE" | "INST" | "OBJ" | "NEWOBJ_EX" | "STACK_GLOBAL"
        );
        let is_foreign = matches!(own.name, "EXT1" | "EXT2" | "EXT4" | "PERSID" | "BINPERSID");
        if is_stranger || is_foreign || is_call && !may_call {
            let import = import.map(|(module, name)| format!("{module}.{name}"));
            dangers.push(Danger {
                offset: own.offset,
                opcode: own.name,
                import: import.filter(|text| text != "."),
            });
        }
        texts.follow(&own);
        at = next;
        if own.name == "STOP" {
            return Walk {
                dangers,
                end: Ok(at),
            };
        }
    }
}

fn lossy(text: &[u8]) -> String {
    String::from_utf8_lossy(text).into_owned()
}

/// Places of texts that are kept at most.
const MOST_KEPT: usize = 1 << 18;

/// The texts that were pushed last, which name what `STACK_GLOBAL` imports. Whatever could bring
/// another one in between makes them unknown.
#[derive(Default)]
struct Texts<'b> {
    last: [Option<&'b [u8]>; 2],
    memo: BTreeMap<u64, Option<&'b [u8]>>,
}

impl<'b> Texts<'b> {
    fn follow(&mut self, own: &Opcode<'b>) {
        let [_, last] = self.last;
        match own.name {
            "SHORT_BINUNICODE" | "BINUNICODE" | "BINUNICODE8" => {
                self.last = [last, Some(own.argument)];
            }
            "MEMOIZE" => self.keep(self.memo.len() as u64, last),
            "BINPUT" | "LONG_BINPUT" => self.keep(unsigned(own.argument), last),
            "BINGET" | "LONG_BINGET" => {
                let found = self.memo.get(&unsigned(own.argument)).copied().flatten();
                self.last = [last, found];
            }
            "PROTO" | "FRAME" => {}
            _ => self.last = [None, None],
        }
    }

    /// Texts beyond those that are kept are unknown.
    fn keep(&mut self, place: u64, text: Option<&'b [u8]>) {
        if self.memo.len() < MOST_KEPT || self.memo.contains_key(&place) {
            self.memo.insert(place, text);
        }
    }

    fn last_two(&self) -> (String, String) {
        let [module, name] = self.last.map(|text| text.map(lossy).unwrap_or_default());
        (module, name)
    }
}
