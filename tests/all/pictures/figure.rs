//! Draws an OBJ: its group `body` from in front and a little from the side, each face in its own
//! grey.

use std::fmt::Write;

/// Pixels for a unit of the mesh: the head and shoulders are in the picture.
const SCALE: f64 = 62.0;
/// Sine and cosine of the turn about the upright axis, then of the tilt.
const TURN: [f64; 2] = [0.5, 0.866_025_403_784];
const TILT: [f64; 2] = [0.173_648_177_667, 0.984_807_753_012];
/// Where the light comes from, of length 1.
const LIGHT: [f64; 3] = [-0.4, 0.65, 0.646];

/// The picture, and where the drawings end (their feet are below) and the words stand.
const WIDTH: f64 = 520.0;
const HEIGHT: f64 = 300.0;
const FEET: f64 = 680.0;
const WORDS: f64 = 284.0;
const CUT: f64 = 256.0;

type Point = [f64; 3];

/// A drawn mesh: its faces as polygons, and the box around them.
pub(super) struct Drawing {
    faces: Vec<(Vec<Point>, f64)>,
}

impl Drawing {
    pub(super) fn of(obj: &str) -> Self {
        let numbers = |line: &str| {
            line.split(' ')
                .skip(1)
                .map(|word| word.parse().unwrap())
                .collect::<Vec<f64>>()
        };
        let points: Vec<Point> = lines(obj, "v")
            .map(|line| turned(numbers(line).try_into().unwrap()))
            .collect();
        let body = obj.split_once("\ng body\n").unwrap().1;
        let body = body.split_once("\ng ").map_or(body, |(body, _)| body);
        let mut faces: Vec<(Vec<Point>, f64)> = Vec::new();
        for line in lines(body, "f") {
            let face: Vec<Point> = line
                .split(' ')
                .skip(1)
                .map(|corner| points[vertex(corner)])
                .collect();
            let normal = normal(&face);
            if normal[2] > 0.0 {
                let light = dot(normal, LIGHT).max(0.0);
                faces.push((face, 85.0 + 160.0 * light));
            }
        }
        faces.sort_by(|one, other| depth(&one.0).total_cmp(&depth(&other.0)));
        Self { faces }
    }

    /// As polygons around `x`, with the feet at `y`.
    pub(super) fn svg(&self, x: f64, y: f64) -> String {
        let mut svg = String::new();
        for (face, grey) in &self.faces {
            let corners = face
                .iter()
                .map(|point| [x + SCALE * point[0], y - SCALE * point[1]]);
            if corners.clone().all(|[_, y]| y > CUT) {
                continue;
            }
            let corners: Vec<String> = corners.map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
            let color = format!("rgb({grey:.0},{grey:.0},{grey:.0})");
            writeln!(
                svg,
                r#"<polygon points="{}" fill="{color}" stroke="{color}"/>"#,
                corners.join(" ")
            )
            .unwrap();
        }
        svg
    }
}

/// Two drawings side by side with words below.
pub(super) fn two(drawings: [(&Drawing, &str); 2]) -> String {
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\">\n\
         <style>text {{ font: 15px sans-serif; fill: #d6dbe1; text-anchor: middle }}</style>\n\
         <rect width=\"100%\" height=\"100%\" rx=\"4.5\" fill=\"#1b1f26\"/>\n"
    );
    for (place, (drawing, words)) in drawings.into_iter().enumerate() {
        let [left, middle] = [0.0, 0.5].map(|part| (part + place as f64) * WIDTH / 2.0);
        // An element of its own cuts off what is outside of its half.
        writeln!(
            svg,
            r#"<svg x="{left}" width="{}" height="{CUT}">"#,
            WIDTH / 2.0
        )
        .unwrap();
        writeln!(svg, "{}</svg>", drawing.svg(WIDTH / 4.0, FEET)).unwrap();
        writeln!(svg, r#"<text x="{middle}" y="{WORDS}">{words}</text>"#).unwrap();
    }
    svg + "</svg>\n"
}

fn lines<'a>(obj: &'a str, word: &'a str) -> impl Iterator<Item = &'a str> {
    obj.lines()
        .filter(move |line| line.split(' ').next() == Some(word))
}

/// The vertex of `12/34`, from 0.
fn vertex(corner: &str) -> usize {
    corner.split('/').next().unwrap().parse::<usize>().unwrap() - 1
}

/// Turned about the upright axis, then tilted towards the reader.
fn turned([x, y, z]: Point) -> Point {
    let [x, z] = [x * TURN[1] + z * TURN[0], z * TURN[1] - x * TURN[0]];
    [x, y * TILT[1] - z * TILT[0], y * TILT[0] + z * TILT[1]]
}

fn normal(face: &[Point]) -> Point {
    let [a, b] = [minus(face[1], face[0]), minus(face[2], face[0])];
    let cross = [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ];
    let length = dot(cross, cross).sqrt();
    cross.map(|value| value / length)
}

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn depth(face: &[Point]) -> f64 {
    face.iter().map(|point| point[2]).sum::<f64>() / face.len() as f64
}
