use imogene_contract::DeciderForm;

#[test]
fn text_and_forms_are_each_other() {
    for (text, form) in [
        ("tree", DeciderForm::Tree),
        ("chain", DeciderForm::Chain),
        ("cards1", DeciderForm::Cards(1)),
        ("cards256", DeciderForm::Cards(256)),
    ] {
        assert_eq!(text.parse(), Ok(form));
        assert_eq!(form.to_string(), text);
        assert_eq!(form.is_usual(), text == "tree");
    }
}

#[test]
fn what_is_no_form_is_refused_with_what_would_do() {
    let accepted = "is no form of the decider; accepted: tree, chain, and cards1 to cards256";
    let wrong = "Tree chain4 cards cards0 cards257 cards-1";
    for text in wrong.split(' ').chain([""]) {
        let error = text.parse::<DeciderForm>().unwrap_err().to_string();
        let wanted = format!("'{text}' {accepted}");
        assert!(error.starts_with(&wanted), "{error}");
    }
}
