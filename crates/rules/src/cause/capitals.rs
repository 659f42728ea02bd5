//! Two paths that differ in their capitals.

/// The shortest beginnings of both paths that hold the whole difference: a folder, where one
/// differs.
pub(crate) fn differing(written: &str, real: &str) -> (String, String) {
    let (mut a, mut b) = (Vec::new(), Vec::new());
    let mut differ = 0;
    for (index, (left, right)) in written.split('/').zip(real.split('/')).enumerate() {
        a.push(left);
        b.push(right);
        if left != right {
            differ = index + 1;
        }
    }
    a.truncate(differ);
    b.truncate(differ);
    (a.join("/"), b.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_named_without_what_is_in_it() {
        let both = |a: &str, b: &str| (a.to_owned(), b.to_owned());
        assert_eq!(
            differing("t/Head/a.target", "t/head/a.target"),
            both("t/Head", "t/head")
        );
        assert_eq!(
            differing("t/Head/A.target", "t/head/a.target"),
            both("t/Head/A.target", "t/head/a.target")
        );
    }
}
