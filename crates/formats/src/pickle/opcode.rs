//! The instructions of pickles, of all protocols from 0 to 5.

/// What stands behind an instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Argument {
    /// Nothing.
    None,
    /// So many bytes.
    Bytes(usize),
    /// A text up to the end of the line.
    Line,
    /// Two such texts: a module, and a name in it.
    TwoLines,
    /// A length of so many bytes, and as many bytes as it says.
    Counted(usize),
}

use Argument::{Bytes, Counted, Line, None as Nothing, TwoLines};

/// All instructions: code, name as Python's `pickletools` has it, argument.
#[rustfmt::skip]
pub(super) const OPCODES: [(u8, &str, Argument); 68] = [
    (b'(', "MARK", Nothing), (b'.', "STOP", Nothing), (b'0', "POP", Nothing),
    (b'1', "POP_MARK", Nothing), (b'2', "DUP", Nothing), (b'F', "FLOAT", Line), (b'I', "INT", Line),
    (b'J', "BININT", Bytes(4)), (b'K', "BININT1", Bytes(1)), (b'L', "LONG", Line),
    (b'M', "BININT2", Bytes(2)), (b'N', "NONE", Nothing), (b'P', "PERSID", Line),
    (b'Q', "BINPERSID", Nothing), (b'R', "REDUCE", Nothing), (b'S', "STRING", Line),
    (b'T', "BINSTRING", Counted(4)), (b'U', "SHORT_BINSTRING", Counted(1)), (b'V', "UNICODE", Line),
    (b'X', "BINUNICODE", Counted(4)), (b'a', "APPEND", Nothing), (b'b', "BUILD", Nothing),
    (b'c', "GLOBAL", TwoLines), (b'd', "DICT", Nothing), (b'}', "EMPTY_DICT", Nothing),
    (b'e', "APPENDS", Nothing), (b'g', "GET", Line), (b'h', "BINGET", Bytes(1)),
    (b'i', "INST", TwoLines), (b'j', "LONG_BINGET", Bytes(4)), (b'l', "LIST", Nothing),
    (b']', "EMPTY_LIST", Nothing), (b'o', "OBJ", Nothing), (b'p', "PUT", Line),
    (b'q', "BINPUT", Bytes(1)), (b'r', "LONG_BINPUT", Bytes(4)), (b's', "SETITEM", Nothing),
    (b't', "TUPLE", Nothing), (b')', "EMPTY_TUPLE", Nothing), (b'u', "SETITEMS", Nothing),
    (b'G', "BINFLOAT", Bytes(8)), (0x80, "PROTO", Bytes(1)), (0x81, "NEWOBJ", Nothing),
    (0x82, "EXT1", Bytes(1)), (0x83, "EXT2", Bytes(2)), (0x84, "EXT4", Bytes(4)),
    (0x85, "TUPLE1", Nothing), (0x86, "TUPLE2", Nothing), (0x87, "TUPLE3", Nothing),
    (0x88, "NEWTRUE", Nothing), (0x89, "NEWFALSE", Nothing), (0x8a, "LONG1", Counted(1)),
    (0x8b, "LONG4", Counted(4)), (b'B', "BINBYTES", Counted(4)),
    (b'C', "SHORT_BINBYTES", Counted(1)), (0x8c, "SHORT_BINUNICODE", Counted(1)),
    (0x8d, "BINUNICODE8", Counted(8)), (0x8e, "BINBYTES8", Counted(8)),
    (0x8f, "EMPTY_SET", Nothing), (0x90, "ADDITEMS", Nothing), (0x91, "FROZENSET", Nothing),
    (0x92, "NEWOBJ_EX", Nothing), (0x93, "STACK_GLOBAL", Nothing), (0x94, "MEMOIZE", Nothing),
    (0x95, "FRAME", Bytes(8)), (0x96, "BYTEARRAY8", Counted(8)), (0x97, "NEXT_BUFFER", Nothing),
    (0x98, "READONLY_BUFFER", Nothing),
];

/// An instruction with what stands behind it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Opcode<'b> {
    /// Where it begins in the file.
    pub(super) offset: usize,
    /// Its name.
    pub(super) name: &'static str,
    /// The argument: without a length, and without the ends of lines.
    pub(super) argument: &'b [u8],
    /// The second line.
    pub(super) second: &'b [u8],
}

/// Why there is no next instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Break {
    /// The file ends where one should begin, or in the middle of one.
    Truncated,
    /// No instruction has this code.
    Unknown(u8),
}

/// Reads the instruction at `offset`; returns it and where the next one begins.
pub(super) fn read(bytes: &[u8], offset: usize) -> Result<(Opcode<'_>, usize), Break> {
    let code = *bytes.get(offset).ok_or(Break::Truncated)?;
    let (_, name, argument) = OPCODES
        .iter()
        .find(|(own, ..)| *own == code)
        .ok_or(Break::Unknown(code))?;
    let rest = bytes.get(offset + 1..).unwrap_or_default();
    let (argument, second, used) = match *argument {
        Nothing => (Some(&[][..]), &[][..], 0),
        Bytes(count) => (rest.get(..count), &[][..], count),
        Line => line(rest).map_or((None, &[][..], 0), |(text, used)| {
            (Some(text), &[][..], used)
        }),
        TwoLines => two_lines(rest).map_or((None, &[][..], 0), |(one, two, used)| {
            (Some(one), two, used)
        }),
        Counted(width) => counted(rest, width).map_or((None, &[][..], 0), |(text, used)| {
            (Some(text), &[][..], used)
        }),
    };
    let argument = argument.ok_or(Break::Truncated)?;
    Ok((
        Opcode {
            offset,
            name,
            argument,
            second,
        },
        offset + 1 + used,
    ))
}

fn line(rest: &[u8]) -> Option<(&[u8], usize)> {
    let end = rest.iter().position(|byte| *byte == b'\n')?;
    Some((rest.get(..end)?, end + 1))
}

fn two_lines(rest: &[u8]) -> Option<(&[u8], &[u8], usize)> {
    let (one, used) = line(rest)?;
    let (two, more) = line(rest.get(used..)?)?;
    Some((one, two, used + more))
}

fn counted(rest: &[u8], width: usize) -> Option<(&[u8], usize)> {
    let length = usize::try_from(unsigned(rest.get(..width)?)).ok()?;
    let end = width.checked_add(length)?;
    Some((rest.get(width..end)?, end))
}

/// A number of up to eight bytes, the lowest first.
pub(super) fn unsigned(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .rev()
        .take(8)
        .fold(0, |all, byte| all << 8 | u64::from(*byte))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_code_stands_twice() {
        let codes: std::collections::BTreeSet<u8> =
            OPCODES.iter().map(|(code, ..)| *code).collect();
        assert_eq!(codes.len(), OPCODES.len());
    }

    #[test]
    fn arguments_end_where_the_next_instruction_begins() {
        let read = |bytes: &'static [u8]| {
            read(bytes, 0).map(|(own, next)| (own.name, own.argument, own.second, next))
        };
        assert_eq!(read(b"K\x05."), Ok(("BININT1", &b"\x05"[..], &b""[..], 2)));
        assert_eq!(
            read(b"cos\nsystem\n."),
            Ok(("GLOBAL", &b"os"[..], &b"system"[..], 11))
        );
        assert_eq!(
            read(b"X\x02\0\0\0ab."),
            Ok(("BINUNICODE", &b"ab"[..], &b""[..], 7))
        );
        assert_eq!(read(b"X\xff\xff\xff\xffab."), Err(Break::Truncated));
        assert_eq!(
            read(b"\x8d\xff\xff\xff\xff\xff\xff\xff\xff"),
            Err(Break::Truncated)
        );
        assert_eq!(read(b"\xff"), Err(Break::Unknown(0xff)));
        assert_eq!(read(b"cos\nsystem"), Err(Break::Truncated));
    }
}
