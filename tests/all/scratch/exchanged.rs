//! JSON documents in which one value is another one.

use serde_json::Value;

/// Pointers to every value.
pub fn pointers(value: &Value, at: &str, found: &mut Vec<String>) {
    found.push(at.to_owned());
    match value {
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate().take(3) {
                pointers(item, &format!("{at}/{index}"), found);
            }
        }
        Value::Object(members) => {
            for (key, member) in members {
                pointers(
                    member,
                    &format!("{at}/{}", key.replace('~', "~0").replace('/', "~1")),
                    found,
                );
            }
        }
        _ => {}
    }
}

/// A document with one value exchanged, for each value that there is and each that it may become.
pub fn exchanged(whole: &Value, others: &[Value]) -> Vec<(String, Value)> {
    let mut places = Vec::new();
    pointers(whole, "", &mut places);
    let damage = |place: &String, other: &Value| {
        let mut copy = whole.clone();
        *copy.pointer_mut(place).unwrap() = other.clone();
        (format!("{other} at {place:?}"), copy)
    };
    places
        .iter()
        .flat_map(|place| others.iter().map(move |other| damage(place, other)))
        .collect()
}
