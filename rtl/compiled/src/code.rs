//! The functions of a design.

use crate::body::Body;
use crate::layout::Layout;
use cranelift_codegen::Context;
use cranelift_codegen::ir::{AbiParam, InstBuilder, Value};
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Module as _, default_libcall_names};
use imogene_hdl::{Design, Module};
use std::collections::HashMap;
use std::mem::ManuallyDrop;
use std::rc::Rc;

type Clock = unsafe extern "C" fn(*mut u64);
type Read = unsafe extern "C" fn(*const u64, *mut u64);

/// Machine code of a design: one function for its clock, one for what its points give.
pub(crate) struct Code {
    clock: Clock,
    size: usize,
    read: Option<(Read, usize)>,
    functions: Functions,
}

/// Functions, and what is needed to make more of them.
struct Functions {
    code: ManuallyDrop<JITModule>,
    context: Context,
    builder: FunctionBuilderContext,
    of_modules: HashMap<*const Module, FuncId>,
}

impl Code {
    pub(crate) fn of(design: &Design, layout: &Layout) -> Code {
        let mut functions = Functions::new();
        let modules = design.top.all();
        for module in modules
            .iter()
            .filter(|module| layout.block(module).is_called)
        {
            let of_modules = functions.of_modules.clone();
            let id = functions.add(1, |code, to, parameters| {
                let mut body = Body::new(to, parameters[0], layout, module);
                body.update(&mut |part, to| {
                    code.declare_func_in_func(of_modules[&Rc::as_ptr(part)], to.func)
                });
                body.to
            });
            functions.of_modules.insert(Rc::as_ptr(module), id);
        }
        let clock = functions.address(functions.of_modules[&Rc::as_ptr(&design.top)]);
        Code {
            // SAFETY: the function was made with this signature.
            clock: unsafe { std::mem::transmute::<*const u8, Clock>(clock) },
            size: layout.block(&design.top).size,
            read: None,
            functions,
        }
    }

    /// Makes the function that reads all of these points, if there is none yet.
    pub(crate) fn add_points(&mut self, top: &Rc<Module>, layout: &Layout, points: &[String]) {
        if self.read.is_some_and(|(_, count)| count == points.len()) {
            return;
        }
        let id = self.functions.add(2, |_, to, parameters| {
            let mut body = Body::new(to, parameters[0], layout, top);
            for (index, path) in points.iter().enumerate() {
                let place = body.find(path);
                let value = body.zeros(place);
                body.store(value, parameters[1], index);
            }
            body.to
        });
        let read = self.functions.address(id);
        // SAFETY: the function was made with this signature.
        let read = unsafe { std::mem::transmute::<*const u8, Read>(read) };
        self.read = Some((read, points.len()));
    }

    /// The rising edge.
    pub(crate) fn clock(&self, words: &mut [u64]) {
        assert_eq!(words.len(), self.size);
        // SAFETY: the function reads and writes this block alone, whose size is that of the layout it was made for.
        unsafe { (self.clock)(words.as_mut_ptr()) }
    }

    /// What the points give.
    pub(crate) fn read(&self, words: &[u64], given: &mut [u64]) {
        let (read, count) = self.read.expect("points are added before they are read");
        assert_eq!((words.len(), given.len()), (self.size, count));
        // SAFETY: the function reads this block and writes as many words as there are points.
        unsafe { read(words.as_ptr(), given.as_mut_ptr()) }
    }
}

impl Functions {
    fn new() -> Functions {
        let mut flags = settings::builder();
        for (name, value) in [("opt_level", "speed"), ("enable_verifier", "false")] {
            flags
                .set(name, value)
                .expect("a setting of the code generator");
        }
        let target = cranelift_native::builder().expect("code is generated for this processor");
        let target = target.finish(settings::Flags::new(flags));
        let target = target.expect("settings of this processor");
        let code = JITModule::new(JITBuilder::with_isa(target, default_libcall_names()));
        Functions {
            context: code.make_context(),
            code: ManuallyDrop::new(code),
            builder: FunctionBuilderContext::new(),
            of_modules: HashMap::new(),
        }
    }

    /// Adds a function of so many addresses.
    fn add(
        &mut self,
        parameters: usize,
        write: impl for<'a> FnOnce(&mut JITModule, FunctionBuilder<'a>, &[Value]) -> FunctionBuilder<'a>,
    ) -> FuncId {
        let Functions {
            code,
            context,
            builder,
            ..
        } = self;
        let address = AbiParam::new(code.target_config().pointer_type());
        context.func.signature = code.make_signature();
        context
            .func
            .signature
            .params
            .extend(vec![address; parameters]);
        let mut to = FunctionBuilder::new(&mut context.func, builder);
        let block = to.create_block();
        to.append_block_params_for_function_params(block);
        to.switch_to_block(block);
        to.seal_block(block);
        let parameters = to.block_params(block).to_vec();
        let mut to = write(code, to, &parameters);
        to.ins().return_(&[]);
        to.finalize(code.target_config());
        let signature = &context.func.signature;
        let id = code.declare_anonymous_function(signature);
        let id = id.expect("a function without a name");
        code.define_function(id, context)
            .expect("a function of known operations");
        code.clear_context(context);
        id
    }

    fn address(&mut self, function: FuncId) -> *const u8 {
        self.code.finalize_definitions().expect("memory for code");
        self.code.get_finalized_function(function)
    }
}

impl Drop for Functions {
    fn drop(&mut self) {
        // SAFETY: who holds the functions is dropped with them, and the module is taken once.
        unsafe { ManuallyDrop::take(&mut self.code).free_memory() }
    }
}
