//! Parts that are in other files (ISO 10303-21 files named by a document).

use step21::Exchange;

/// The names of the files that have the shape of a product, without folders.
pub fn external(file: &Exchange, product: Option<u64>) -> Vec<String> {
    let mut names: Vec<String> = vec![];
    for reference in file.all(&["APPLIED_DOCUMENT_REFERENCE"]) {
        let items = reference.entities(2).unwrap_or_default();
        let own = items.iter().any(|item| Some(item.id) == product);
        let document = reference.entity(0).ok().filter(|_| own);
        let Some(document) = document.and_then(|entity| entity.find(&["DOCUMENT_FILE"])) else {
            continue;
        };
        let mut assigned = file.all(&["APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT"]);
        let assigned = assigned.find(|assigned| {
            let items = assigned.entities(3).unwrap_or_default();
            items.iter().any(|item| item.id == document.entity.id)
        });
        let path = assigned.unwrap_or(document).text(0);
        let name = path.rsplit(['/', '\\']).next().unwrap_or_default();
        if !name.is_empty() && !names.iter().any(|known| known == name) {
            names.push(name.to_owned());
        }
    }
    names
}
