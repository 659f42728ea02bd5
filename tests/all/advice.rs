//! What findings advise on the cases of the rules: the name that is meant, and never one that makes
//! it worse.

use crate::scratch::memory::{Asked, Memory};
use crate::scratch::{Case, project};

/// The help of the findings of a rule on one of its cases.
fn help(rule: &str, case: &str) -> Vec<String> {
    let case = Case::read(&project("fixtures/rules").join(rule).join(case));
    let asked = Asked::of(&case).unwrap();
    let mut repository = Memory::example(&case);
    repository.apply(&case);
    let outcome = asked.lint(&repository);
    let own = outcome
        .findings
        .into_iter()
        .filter(|finding| finding.rule == rule);
    own.filter_map(|finding| finding.help).collect()
}

#[test]
fn advice_names_what_is_meant() {
    let cases = [
        // Another map is another picture.
        (
            "material-unknown-keyword",
            "bad-makehuman1-displace",
            "did you mean `displacementmapTexture`?",
        ),
        (
            "material-unknown-keyword",
            "bad-displace",
            "remove the line, or put `# ` in front of it",
        ),
        (
            "material-unknown-keyword",
            "bad-makehuman1-blank-lost",
            "did you mean `name Kilt`?",
        ),
        (
            "material-unknown-keyword",
            "bad-blank-lost",
            "for `nameKilt`: did you mean `name Kilt`?; for `roughnessFactor0.8`: did you mean `roughnessFactor 0.8`?",
        ),
        (
            "material-unknown-keyword",
            "bad-mpfb-blank-lost",
            "did you mean `name Shirt`?",
        ),
        // What Godot leaves beside a picture is none.
        (
            "material-missing-texture",
            "bad-mpfb-import",
            "correct the name, add the picture, or remove the line",
        ),
        (
            "material-opacity",
            "bad-zero",
            "remove `opacity`: the surface stays as it looks",
        ),
        (
            "target-custom-name",
            "bad-folder",
            "rename it to `Whole-Body`",
        ),
        (
            "target-custom-name",
            "bad",
            "rename it to `big-paunch.target`",
        ),
        ("proxy-missing-name", "bad-blank-lost", "write `name Shirt`"),
        (
            "proxy-missing-name",
            "bad-mpfb-blank-lost",
            "write `name Shirt`",
        ),
        (
            "proxy-missing-mesh",
            "bad-makehuman1-blank-lost",
            "write `obj_file kilt.obj`",
        ),
        (
            "proxy-unknown-keyword",
            "bad-blank-lost",
            "did you mean `material shirt.mhmat`?",
        ),
        (
            "model-category",
            "bad-makehuman1-blank-lost",
            "did you mean `name Visitor`?",
        ),
        (
            "model-syntax",
            "bad-mpfb-blank-lost",
            "did you mean `clothes Hat 7f0c9d5e-3a51-4c66-9d0b-0000000000a2`?",
        ),
        (
            "library-name-cut",
            "bad-makehuman1-folder",
            "rename the folder, and what is in it, without spaces",
        ),
    ];
    for (rule, case, expected) in cases {
        assert_eq!(help(rule, case), [expected], "{rule}/{case}");
    }
    let of_model = [
        "did you mean `name Visitor`?",
        "did you mean `modifier head/head-age 0.5`?",
    ];
    assert_eq!(help("model-category", "bad-blank-lost"), of_model);
}
