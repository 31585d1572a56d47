//! Parts that are in other files (ISO 10303-21 files named by a document).

use super::exchange::Exchange;

/// The names of the files that have the shape of a product, without folders.
pub fn external(file: &Exchange, product: Option<u64>) -> Vec<String> {
    let Some(product) = product else {
        return vec![];
    };
    let mut names = vec![];
    for reference in file.all(&["APPLIED_DOCUMENT_REFERENCE"]) {
        let of_product = reference
            .entities(2)
            .is_ok_and(|items| items.iter().any(|item| item.id == product));
        let Ok(document) = reference.entity(0) else {
            continue;
        };
        let Some(document) = file
            .find(document, &["DOCUMENT_FILE"])
            .filter(|_| of_product)
        else {
            continue;
        };
        let assigned = file
            .all(&["APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT"])
            .find(|assigned| {
                let items = assigned.entities(3).unwrap_or_default();
                items.iter().any(|item| item.id == document.entity.id)
            });
        let path = assigned.map_or_else(|| document.text(0), |assigned| assigned.text(0));
        let name = path.rsplit(['/', '\\']).next().unwrap_or_default();
        if !name.is_empty() && !names.iter().any(|known| known == name) {
            names.push(name.to_owned());
        }
    }
    names
}
