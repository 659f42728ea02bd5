//! GLSL sources of `MakeHuman` 1: which defines they ask for, which parameters they have
//! (`docs/loaders/makehuman1/shaders.md#defines-and-uniforms`).

use std::collections::{BTreeMap, BTreeSet};

use super::fields::fields;
use mhlint_source::lines;

/// One source of a shader.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ShaderSource {
    /// The names that it asks for with `#ifdef` or `#ifndef`, as the application finds them: also
    /// in comments.
    pub defines: BTreeSet<Box<str>>,
    /// Its parameters by name.
    pub uniforms: BTreeMap<Box<str>, Uniform>,
    /// Whether the word `main` is in the code.
    pub has_main: bool,
}

/// A parameter of a shader.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Uniform {
    /// What it takes.
    pub value: Shape,
    /// Whether it is declared and used whatever is defined. Others may not be there in the end.
    pub is_certain: bool,
}

/// What a parameter takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A picture.
    Picture,
    /// As many numbers.
    Numbers(usize),
    /// Anything else.
    Other,
}

/// Reads a source.
pub fn read(text: &[u8]) -> ShaderSource {
    let mut source = ShaderSource {
        defines: defines(text),
        ..ShaderSource::default()
    };
    let mut words = Words {
        code: without_comments(text),
        at: 0,
        depth: 0,
    };
    let mut used: BTreeSet<Box<str>> = BTreeSet::new();
    while let Some(word) = words.next() {
        source.has_main |= &*word == "main";
        if &*word != "uniform" {
            if words.depth == 0 && source.uniforms.contains_key(&*word) {
                used.insert(word);
            }
            continue;
        }
        let is_outermost = words.depth == 0;
        for (name, value) in declared(&mut words) {
            let uniform = Uniform {
                value,
                is_certain: is_outermost,
            };
            source.uniforms.entry(name).or_insert(uniform);
        }
    }
    for (name, uniform) in &mut source.uniforms {
        uniform.is_certain &= used.contains(name);
    }
    source
}

/// The second word of lines whose first one is `#ifdef` or `#ifndef`.
fn defines(text: &[u8]) -> BTreeSet<Box<str>> {
    let asked = lines(text).filter_map(|(_, line)| {
        let words = fields(line);
        let is_asked = words
            .first()
            .is_some_and(|(_, first)| matches!(*first, b"#ifdef" | b"#ifndef"));
        words
            .get(1)
            .filter(|_| is_asked)
            .map(|(_, name)| String::from_utf8_lossy(name).into())
    });
    asked.collect()
}

/// `highp float a = 1.0, b;` behind `uniform`: the names, with what they take.
fn declared(words: &mut Words) -> Vec<(Box<str>, Shape)> {
    let mut kind = words.next();
    while kind
        .as_deref()
        .is_some_and(|word| matches!(word, "lowp" | "mediump" | "highp"))
    {
        kind = words.next();
    }
    let shape = kind.map_or(Shape::Other, |kind| shape(&kind));
    let mut names = Vec::new();
    while let Some(name) = words.next() {
        let is_array = words.is_next(b'[');
        names.push((name, if is_array { Shape::Other } else { shape }));
        if words.skip_value() != Some(b',') {
            break;
        }
    }
    names
}

fn shape(kind: &str) -> Shape {
    match kind {
        "float" | "int" | "uint" | "bool" => Shape::Numbers(1),
        _ if kind.starts_with("sampler") => Shape::Picture,
        _ => match kind.trim_start_matches(['i', 'u', 'b']) {
            "vec2" => Shape::Numbers(2),
            "vec3" => Shape::Numbers(3),
            "vec4" => Shape::Numbers(4),
            "mat2" | "mat2x2" => Shape::Numbers(4),
            "mat2x3" | "mat3x2" => Shape::Numbers(6),
            "mat2x4" | "mat4x2" => Shape::Numbers(8),
            "mat3" | "mat3x3" => Shape::Numbers(9),
            "mat3x4" | "mat4x3" => Shape::Numbers(12),
            "mat4" | "mat4x4" => Shape::Numbers(16),
            _ => Shape::Other,
        },
    }
}

/// The code with blanks in place of comments.
fn without_comments(text: &[u8]) -> Vec<u8> {
    let mut code = Vec::with_capacity(text.len());
    let mut rest = text;
    while let Some((first, behind)) = rest.split_first() {
        let end = match rest.get(..2) {
            Some(b"//") => rest.iter().position(|byte| *byte == b'\n'),
            Some(b"/*") => rest
                .get(2..)
                .and_then(|rest| rest.windows(2).position(|two| two == b"*/"))
                .map(|at| at + 4),
            _ => {
                code.push(*first);
                rest = behind;
                continue;
            }
        };
        code.push(b' ');
        rest = end.and_then(|end| rest.get(end..)).unwrap_or_default();
    }
    code
}

/// The words of code in turn, and how many `#if` they are below.
struct Words {
    code: Vec<u8>,
    at: usize,
    depth: usize,
}

impl Words {
    fn next(&mut self) -> Option<Box<str>> {
        loop {
            match self.code.get(self.at)? {
                b'#' => self.directive(),
                byte if is_of_word(*byte) => break,
                _ => self.at += 1,
            }
        }
        let rest = self.code.get(self.at..)?;
        let length = rest
            .iter()
            .position(|byte| !is_of_word(*byte))
            .unwrap_or(rest.len());
        self.at += length;
        rest.get(..length)
            .map(|word| String::from_utf8_lossy(word).into())
    }

    /// Passes over a line of the preprocessor.
    fn directive(&mut self) {
        let rest = self.code.get(self.at..).unwrap_or_default();
        let line = rest.split(|byte| *byte == b'\n').next().unwrap_or_default();
        let word = line.get(1..).unwrap_or_default().trim_ascii_start();
        if word.starts_with(b"if") {
            self.depth += 1;
        } else if word.starts_with(b"endif") {
            self.depth = self.depth.saturating_sub(1);
        }
        self.at += line.len().max(1);
    }

    fn is_next(&self, byte: u8) -> bool {
        let rest = self.code.get(self.at..).unwrap_or_default();
        rest.trim_ascii_start().first() == Some(&byte)
    }

    /// Passes over what is behind a name, up to the comma or the semicolon that ends it.
    fn skip_value(&mut self) -> Option<u8> {
        let mut open = 0_usize;
        while let Some(byte) = self.code.get(self.at) {
            self.at += 1;
            match byte {
                b'(' | b'[' | b'{' => open += 1,
                b')' | b']' | b'}' => open = open.saturating_sub(1),
                b';' => return Some(b';'),
                b',' if open == 0 => return Some(b','),
                _ => {}
            }
        }
        None
    }
}

const fn is_of_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const SOURCE: &[u8] =
        b"#version 120\n/* uniform float no;\n#ifdef IN_COMMENT\n*/\n// uniform float neither;\n\
        #ifdef DIFFUSE\n  uniform sampler2D diffuseTexture;\n#endif\n # ifdef NOT\n#endif\n#if \
        defined(NOR)\n#endif\n\
        uniform highp vec3 tint = vec3(1.0, 0.5, 0), edge;\nuniform float glow, unused;\nuniform \
        mat4 bones[20];\n\
        uniform sampler2D ball;\nvoid main() { x = tint * glow * edge * bones[0] + ball; y = \
        diffuseTexture; }\n";

    #[test]
    fn names_are_found_as_the_application_finds_them() {
        let source = read(SOURCE);
        assert_eq!(
            source
                .defines
                .iter()
                .map(|name| &**name)
                .collect::<Vec<_>>(),
            ["DIFFUSE", "IN_COMMENT"]
        );
        let told: Vec<_> = source
            .uniforms
            .iter()
            .map(|(name, one)| (&**name, one.value, one.is_certain))
            .collect();
        let expected = [
            ("ball", Shape::Picture, true),
            ("bones", Shape::Other, true),
            ("diffuseTexture", Shape::Picture, false),
            ("edge", Shape::Numbers(3), true),
            ("glow", Shape::Numbers(1), true),
            ("tint", Shape::Numbers(3), true),
            ("unused", Shape::Numbers(1), false),
        ];
        assert_eq!(told, expected);
    }

    #[test]
    fn what_does_not_end_ends_with_the_file() {
        for text in [
            "uniform",
            "uniform float",
            "uniform float a",
            "uniform float a = (1, 2",
            "/* uniform float a;",
            "#",
        ] {
            assert!(read(text.as_bytes()).uniforms.len() <= 1, "{text}");
        }
    }

    proptest! {
        #[test]
        fn hostile_bytes_are_read(text in proptest::collection::vec(any::<u8>(), 0..200)) {
            prop_assert!(read(&text).uniforms.len() <= text.len());
        }

        #[test]
        fn every_uniform_that_is_written_is_found(names in proptest::collection::btree_set("u[a-z]{1,8}x", 1..20)) {
            let text: Vec<String> = names.iter().map(|name| format!("uniform vec2 {name};\n")).collect();
            let source = read(text.concat().as_bytes());
            prop_assert!(names.iter().all(|name| source.uniforms.contains_key(name.as_str())));
            prop_assert_eq!(source.uniforms.len(), names.len());
        }
    }
}
