//! The page of `imogene trade` in a real browser: Chromium without a screen, which `scripts/setup` installs.

use imogene_plan::description::MachineDescription;
use imogene_plan::pace::Timing;
use imogene_scene::SceneFile;
use imogene_studies::trade::design::Space;
use imogene_studies::trade::page::page;
use imogene_studies::trade::point::Cost;
use imogene_studies::trade::run::{Request, run};
use regex::Regex;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;
use std::sync::LazyLock;
use tempfile::TempDir;

/// A page of a dozen points with costs that are a sum of widths.
static PAGE: LazyLock<(TempDir, String)> = LazyLock::new(|| {
    let folder = tempfile::tempdir().unwrap();
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/cut-sphere.toml");
    let cost = |machine: &MachineDescription| -> Cost {
        let w = machine.words();
        let cells = u64::from(100 * (w.depth + w.root) + 3 * w.guard_quadratic);
        Cost {
            lut: cells / 2,
            ff: cells / 3,
            dsp: 0,
            bram: 0,
            is_estimated: false,
            cells: cells + u64::from(machine.rows_per_stage),
            fmax_mhz: Some(150.0),
        }
    };
    let request = Request {
        file: &SceneFile::read(&scene).unwrap(),
        name: "scenes/cut-sphere.toml",
        size: (64, 48),
        target: "ecp5-45k",
        designs: Space::Quick.designs(64),
        out: folder.path(),
        version: "0",
        program: "test",
        costs: &|machines, _| Ok(machines.iter().map(cost).collect()),
        with_clock: true,
        timing: &|_| Timing::default(),
        done: &|_| (),
    };
    let trade = run(&request).unwrap();
    let text = page(&trade, folder.path()).unwrap();
    (folder, text)
});

/// What the browser makes of a page with this address: its document, and what it logged.
fn browse(text: &str, address: &str) -> (String, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("index.html");
    std::fs::write(&file, text).unwrap();
    let options = "--headless --no-sandbox --disable-gpu --disable-dev-shm-usage --dump-dom \
        --virtual-time-budget=5000 --enable-logging=stderr --v=0";
    let profile = folder.path().join("profile");
    let output = Command::new("chromium")
        .args(options.split_whitespace())
        .arg(format!("--user-data-dir={}", profile.display()))
        .arg(format!("file://{}{address}", file.display()))
        .output()
        .expect("chromium runs; scripts/setup installs it");
    let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
    (text(&output.stdout), text(&output.stderr))
}

/// The document, which came without an error.
fn opened(address: &str) -> String {
    without_error(&PAGE.1, address)
}

fn without_error(text: &str, address: &str) -> String {
    let (document, log) = browse(text, address);
    assert!(document.contains("data-errors=\"0\""), "{log}");
    assert!(!log.contains("CONSOLE"), "{log}");
    document
}

/// What an expression finds, its first group.
fn all(expression: &str, text: &str) -> Vec<String> {
    let expression = Regex::new(expression).unwrap();
    let found = expression.captures_iter(text);
    found.map(|c| c[1].to_owned()).collect()
}

fn column(document: &str, key: &str) -> Vec<f64> {
    let cells = all(&format!("<td data-column=\"{key}\">([^<]*)</td>"), document);
    cells.iter().map(|v| v.parse().unwrap()).collect()
}

fn selected(document: &str) -> Vec<String> {
    let rows = all("(<tr [^>]*aria-selected=\"true\"[^>]*>)", document);
    let name = |row: &String| all("data-point=\"([^\"]*)\"", row)[0].clone();
    rows.iter().map(name).collect()
}

#[test]
fn the_table_is_sorted_as_the_address_says() {
    let document = opened("#sort=cells");
    let cells = column(&document, "cells");
    assert_eq!(cells.len(), Space::Quick.designs(64).len());
    assert!(cells.is_sorted(), "{cells:?}");
    assert!(document.contains("aria-sort=\"ascending\""));
    let cells = column(&opened("#sort=cells&dir=desc"), "cells");
    assert!(cells.iter().rev().is_sorted() && cells[0] > cells[cells.len() - 1]);
    let silhouettes = column(&opened("#sort=silh"), "silh");
    assert!(silhouettes.is_sorted(), "{silhouettes:?}");
}

#[test]
fn the_filter_keeps_what_it_says() {
    let document = opened("#filter=w%3E%3D20+r%3D1");
    let (widths, rows) = (column(&document, "w"), column(&document, "r"));
    assert_eq!(widths, [20.0, 20.0, 24.0]);
    assert!(rows.iter().all(|r| *r == 1.0));
    assert!(document.contains("3 of 22 points"));
    // Marks of the others are faint.
    let mark = "<circle data-point=\"([^\"]*)\"[^>]*class=\"out\"";
    let names: BTreeSet<String> = all(mark, &document).into_iter().collect();
    assert_eq!(names.len(), 22 - 3);
    assert_eq!(column(&opened("#filter=g2.4"), "w"), [16.0, 16.0]);
}

#[test]
fn a_selected_point_shows_its_picture_its_map_and_its_command() {
    let id = "w16-n16-g2.4-d0-r2";
    let document = opened(&format!("#point={id}"));
    assert_eq!(selected(&document), [id]);
    let image = "<img id=\"picture\" src=\"(data:image/png;base64,[^\"]*)\"";
    let picture = all(image, &document);
    let data: serde_json::Value = {
        let text = all("(?s)id=\"data\">(.*?)</script>", &PAGE.1)[0].clone();
        serde_json::from_str(&text).unwrap()
    };
    let of = |file: &str| data["pictures"][file].as_str().unwrap().to_owned();
    assert_eq!(picture, [of("pictures/w16-n16-g2.4-d0.png")]);
    let command = all("<pre tabindex=\"0\">([^<]*)</pre>", &document);
    let begin = "imogene machine scenes/cut-sphere.toml --machine ";
    assert!(command[0].starts_with(begin), "{command:?}");
    assert!(command[0].contains(&format!("/machines/{id}.toml ")));
    let document = opened(&format!("#point={id}&view=map"));
    let map = all("<img id=\"picture\" src=\"([^\"]*)\"", &document);
    assert_eq!(map, [of("maps/w16-n16-g2.4-d0.png")]);
    assert!(document.contains("wrong object"));
}

/// What a person does, done by a script at the end of the page.
fn acted(script: &str, address: &str) -> String {
    let script =
        format!("<script>{script}; document.body.dataset.address = location.hash</script></body>");
    without_error(&PAGE.1.replace("</body>", &script), address)
}

#[test]
fn clicks_and_keys_select_sort_and_write_the_address() {
    let address = |document: &str| all("data-address=\"([^\"]*)\"", document)[0].clone();
    let id = "w20-n16-g0.0-d3-r1";
    let click = format!(
        "document.querySelector('circle[data-point=\"{id}\"]').dispatchEvent(new MouseEvent('click', {{ bubbles: true }}))"
    );
    let document = acted(&click, "#sort=w");
    assert_eq!(selected(&document), [id]);
    assert_eq!(address(&document), format!("#sort=w&amp;point={id}"));
    let down = "document.querySelector('tbody tr').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowDown', bubbles: true }))";
    let document = acted(down, "#sort=w");
    assert_eq!(selected(&document), ["w10-n16-g0.0-d0-r2"]);
    let head =
        "[...document.querySelectorAll('th button')].find(b => b.textContent === 'cells').click();";
    let document = acted(&head.repeat(2), "#sort=w");
    assert_eq!(address(&document), "#dir=desc");
    assert!(column(&document, "cells").iter().rev().is_sorted());
    let filter = "const f = document.getElementById('filter'); f.value = 'w=24'; f.dispatchEvent(new Event('input'))";
    let document = acted(filter, "");
    assert_eq!(address(&document), "#filter=w%3D24");
    assert_eq!(column(&document, "w"), [24.0; 2]);
}

#[test]
fn an_error_of_the_page_would_be_seen() {
    let script = "<script>throw new Error('broken')</script></body>";
    let broken = PAGE.1.replace("</body>", script);
    let (document, log) = browse(&broken, "");
    assert!(document.contains("data-errors=\"1\""));
    assert!(log.contains("CONSOLE") && log.contains("broken"), "{log}");
}

#[test]
fn the_columns_are_explained_on_the_page() {
    let document = opened("");
    assert!(document.contains("What the columns mean"));
    for (heading, meaning) in [
        ("K", "square root"),
        ("part", "wrong face"),
        ("toggles", "power"),
        ("frames/s", "per second"),
    ] {
        let item = format!("<dt>{heading}</dt><dd>([^<]*)</dd>");
        let found = all(&item, &document);
        let is_explained = found.iter().any(|text| text.contains(meaning));
        assert!(is_explained, "{heading}: {found:?}");
    }
}

#[test]
fn nothing_is_taken_from_outside() {
    let text = &PAGE.1;
    for outside in "src=\"http href=\"http @import url( fetch( XMLHttp".split(' ') {
        assert!(!text.contains(outside), "{outside}");
    }
    // The name space of SVG is no address.
    for address in all("(https?://[^\"' <]*)", text) {
        assert_eq!(address, "http://www.w3.org/2000/svg");
    }
}
