(* Reads certificates (docs/certificate.md), and says which of them the checker accepts that Coq has proved right
   (verified_checker.v, of paths verified_path_checker.v). What is read is not proved to be what is in the file. With --coq all of it is shown: a file
   is written of which the theorem is what the certificate states, for coqc to prove by computing `accept` itself.

   Of a certificate the checker takes the curve, its invariants, the rate, gamma of the Frenet frame, the claims about
   angles, and the decisions that an identity or a few values prove. What it leaves out is said at the end. *)

module A = Accept
module Int = Big_int_Z

exception Malformed of string

(* ---- JSON: as much as there is in a certificate. *)

type json =
  | Null | Bool of bool | Number of string | Text of string | Items of json list
  | Fields of (string * json) list

let parse text =
  let length = String.length text in
  let at = ref (if length >= 3 && String.sub text 0 3 = "\xEF\xBB\xBF" then 3 else 0) in
  let fail what = raise (Malformed (Printf.sprintf "byte %d: %s" !at what)) in
  let peek () = if !at < length then text.[!at] else '\000' in
  let rec blank () = match peek () with ' ' | '\t' | '\n' | '\r' when !at < length -> incr at; blank () | _ -> () in
  let expect c = if !at < length && peek () = c then incr at else fail (Printf.sprintf "'%c' is wanted" c) in
  let word w value =
    let n = String.length w in
    if !at + n <= length && String.sub text !at n = w then (at := !at + n; value) else fail "a value is wanted" in
  let rec characters out =
    if !at >= length then fail "a string without an end" else
    match text.[!at] with
    | '"' -> incr at; Buffer.contents out
    | '\\' ->  (* no key and no number has one: kept as it is *)
        if !at + 1 >= length then fail "a string without an end";
        Buffer.add_string out (String.sub text !at 2); at := !at + 2; characters out
    | c -> incr at; Buffer.add_char out c; characters out in
  let string () = expect '"'; characters (Buffer.create 16) in
  (* What is between two brackets, with commas. *)
  let rec listed close item =
    blank ();
    if peek () = close then (incr at; []) else more close item
  and more close item =
    let first = item () in
    blank ();
    if peek () = ',' then (incr at; blank (); first :: more close item) else (expect close; [first]) in
  let rec value depth =
    if depth > 100 then fail "nested too deeply";
    blank ();
    match peek () with
    | '{' ->
        incr at;
        let field () =
          blank ();
          let key = string () in
          blank (); expect ':';
          (key, value (depth + 1)) in
        let fields = listed '}' field in
        let keys = List.map fst fields in
        if List.length (List.sort_uniq compare keys) < List.length keys then fail "a key is there twice";
        Fields fields
    | '[' -> incr at; Items (listed ']' (fun () -> value (depth + 1)))
    | '"' -> Text (string ())
    | 't' -> word "true" (Bool true)
    | 'f' -> word "false" (Bool false)
    | 'n' -> word "null" Null
    | '-' | '0' .. '9' ->
        let from = !at in
        while (match peek () with '-' | '+' | '.' | 'e' | 'E' | '0' .. '9' -> true | _ -> false) do incr at done;
        Number (String.sub text from (!at - from))
    | _ -> fail "a value is wanted" in
  let found = value 0 in
  blank ();
  if !at < length then fail "something is behind the end";
  found

(* ---- A certificate *)

let fail place what = raise (Malformed (place ^ ": " ^ what))

let find key place = function
  | Fields fields ->
      (match List.assoc_opt key fields with Some x -> x | None -> fail place ("the key \"" ^ key ^ "\" is missing"))
  | _ -> fail place "an object is wanted"
let find_optional key = function Fields fields -> List.assoc_opt key fields | _ -> None

let items place = function Items l -> l | _ -> fail place "a list is wanted"
let text place = function Text s -> s | _ -> fail place "a string is wanted"

let is_number s = s <> "" && String.for_all (function '0' .. '9' -> true | _ -> false) s
let integer place s =
  let digits = if s <> "" && s.[0] = '-' then String.sub s 1 (String.length s - 1) else s in
  if is_number digits then Int.big_int_of_string s else fail place ("an integer is wanted, not \"" ^ s ^ "\"")

let fraction n d : A.q = { A.qnum = n; A.qden = d }

let exact place x =
  let s = text place x in
  match String.index_opt s '/' with
  | None -> fraction (integer place s) Int.unit_big_int
  | Some k ->
      let below = String.sub s (k + 1) (String.length s - k - 1) in
      let d = if is_number below then Int.big_int_of_string below else fail place "a denominator is wanted" in
      if Int.sign_big_int d = 0 then fail place "the denominator is 0";
      fraction (integer place (String.sub s 0 k)) d

let power_of_10 n = Int.power_int_positive_int 10 n

let decimal place x =
  let s = text place x in
  let head, exponent = match String.index_opt s 'e' with
    | None -> s, 0
    | Some k ->
        let e = integer place (String.sub s (k + 1) (String.length s - k - 1)) in
        if Int.gt_big_int (Int.abs_big_int e) (Int.big_int_of_int 10000) then
          fail place "exponents are limited to 10000";
        String.sub s 0 k, Int.int_of_big_int e in
  let digits, exponent = match String.index_opt head '.' with
    | None -> head, exponent
    | Some k ->
        let after = String.sub head (k + 1) (String.length head - k - 1) in
        if not (is_number after) || k = 0 then fail place "a decimal number is wanted";
        String.sub head 0 k ^ after, exponent - String.length after in
  let n = integer place digits in
  if exponent < 0 then fraction n (power_of_10 (- exponent))
  else fraction (Int.mult_big_int n (power_of_10 exponent)) Int.unit_big_int

let polynomial place x = List.map (exact place) (items place x)
let some_polynomial place x = match polynomial place x with [] -> fail place "a coefficient is wanted" | a -> a

let claim place x =
  let what key read = read (place ^ "/" ^ key) (find key place x) in
  let of_text key = text (place ^ "/" ^ key) (find key place x) in
  let said = Printf.sprintf "|theta(%s) - %s| <= %s" (of_text "t") (of_text "theta") (of_text "radius") in
  (said, { A.time = what "t" exact; A.angle = what "theta" decimal; A.radius = what "radius" decimal })

(* The decisions: (as they are printed, what the checker takes of each, if it does). *)
let decisions place x =
  let answer key = match find "answer" (place ^ "/" ^ key) (find key place x) with
    | Bool b -> b
    | _ -> fail (place ^ "/" ^ key) "true or false is wanted" in
  let witness key what = find what (place ^ "/" ^ key) (find key place x) in
  let vector key what = match List.map (exact (place ^ "/" ^ key)) (items (place ^ "/" ^ key) (witness key what)) with
    | [a; b; c] -> ((a, b), c)
    | _ -> fail (place ^ "/" ^ key) "three numbers are wanted" in
  (* Those of the zeros that are rational. *)
  let zeros key what =
    let at = place ^ "/" ^ key ^ "/" ^ what in
    let rational x = match find "t" at x with Text _ as t -> Some (exact at t) | _ -> None in
    List.filter_map rational (items at (witness key what)) in
  let taken = function
    | "regular", true -> Some A.Regular
    | "regular", false -> Some (A.NotRegular (zeros "regular" "cusps"))
    | "inflections", true -> Some (A.Inflection (zeros "inflections" "points"))
    | "inflections", false -> Some A.NoInflection
    | "line", true -> Some (A.Line (vector "line" "direction"))
    | "line", false -> Some A.NotLine
    | "planar", true -> Some (A.Planar (vector "planar" "normal"))
    | "planar", false -> Some A.NotPlanar
    | "helical", true ->
        Some (A.Helical (vector "helical" "axis", exact (place ^ "/helical") (witness "helical" "cos_squared")))
    | "helical", false when not (answer "planar") -> Some A.NotHelical
    | "erf_is_rmf", true -> Some A.ErfIsRmf
    | "erf_is_rmf", false -> Some A.ErfIsNotRmf
    | "rrmf", true ->
        let w = witness "rrmf" "w" and at = place ^ "/rrmf" in
        Some (A.Rrmf (polynomial at (find "re" at w), polynomial at (find "im" at w)))
    | "double_ph", true ->
        let at = place ^ "/double_ph" in
        Some (A.DoublePh (polynomial at (witness "double_ph" "omega"), exact at (witness "double_ph" "constant")))
    | "erf_monotone", is_true -> Some (if is_true then A.Monotone else A.NotMonotone)
    | _ -> None in
  let keys = match x with Fields fields -> List.map fst fields | _ -> fail place "an object is wanted" in
  let one key = (Printf.sprintf "decision %s: %s" key (if answer key then "yes" else "no"), taken (key, answer key)) in
  List.map one keys

(* What is in a file. *)
type found = {
  certificate : A.certificate;
  start : (A.q * A.q) * A.q;
  claims : string list; (* as they are written *)
  decisions : string list;
  left_out : string list }

let certificate place x =
  let is key value x =
    if find key place x <> Text value then fail (place ^ "/" ^ key) ("\"" ^ value ^ "\" is wanted") in
  is "phrame" "certificate/1" x;
  let inside key = find key place x and at key = place ^ "/" ^ key in
  let curve = inside "curve" in
  is "phrame" "curve/1" curve;
  is "basis" "power" curve;
  let part of_what key = polynomial (at key) (find key place of_what) in
  let preimage = find "preimage" (at "curve") curve in
  let coordinate key = some_polynomial (at "curve/preimage/" ^ key) (find key (at "curve/preimage") preimage) in
  let g = inside "g" and rate = inside "rate" in
  let rational = find "rational" (at "antiderivative") (inside "antiderivative") in
  let x', y', z' = match items (at "hodograph") (inside "hodograph") with
    | [x; y; z] -> polynomial (at "hodograph") x, polynomial (at "hodograph") y, polynomial (at "hodograph") z
    | _ -> fail (at "hodograph") "three polynomials are wanted" in
  let claims = items (at "claims") (inside "claims") in
  let claims = List.mapi (fun k -> claim (Printf.sprintf "%s/%d" (at "claims") k)) claims in
  let bend = match text (at "frame") (inside "frame") with
    | "erf" -> None
    | "frenet" ->
        let bend = inside "bend" in
        let gamma = find "polynomial" (at "bend") bend in
        Some ((part gamma "re", part gamma "im"), part bend "content")
    | _ -> fail (at "frame") "\"erf\" or \"frenet\" is wanted" in
  let multiplier = match find_optional "multiplier" curve with
    | Some f -> some_polynomial (at "curve/multiplier") f
    | None -> [fraction Int.unit_big_int Int.unit_big_int] in
  let zero = fraction Int.zero_big_int Int.unit_big_int in
  let start = match Option.map (polynomial (at "curve/start")) (find_optional "start" curve) with
    | None -> ((zero, zero), zero)
    | Some [a; b; c] -> ((a, b), c)
    | Some _ -> fail (at "curve/start") "three numbers are wanted" in
  let taken, left_out = List.partition (fun (_, x) -> x <> None) (decisions (at "decisions") (inside "decisions")) in
  let certificate = {
     A.cu = coordinate "u"; A.cv = coordinate "v"; A.cp = coordinate "p"; A.cq = coordinate "q";
     A.multiplier = multiplier;
     A.cx' = x'; A.cy' = y'; A.cz' = z'; A.csigma = part x "sigma"; A.ch = part x "h";
     A.cg_re = part g "re"; A.cg_im = part g "im"; A.numerator = part rate "numerator";
     A.denominator = part rate "denominator"; A.common = part rate "common"; A.bend = bend;
     A.rational = (part rational "numerator", part rational "denominator");
     A.claims = List.map snd claims;
     A.decisions = List.filter_map snd taken } in
  { certificate; start; claims = List.map fst claims; decisions = List.map fst taken;
    left_out = "the antiderivative" :: "its roots and residues" :: "the lists of zeros" :: List.map fst left_out }

(* That of a path: its segments, and its claims as they are written. *)
let path_certificate x =
  let segments = items "/segments" (find "segments" "" x) and claims = items "/claims" (find "claims" "" x) in
  let segment k x =
    let found = certificate (Printf.sprintf "/segments/%d" k) x in
    if found.certificate.A.bend <> None then fail (Printf.sprintf "/segments/%d/frame" k) "\"erf\" is wanted";
    found in
  if segments = [] then fail "/segments" "a segment is wanted";
  List.mapi segment segments, List.mapi (fun k -> claim (Printf.sprintf "/claims/%d" k)) claims

(* ---- What is answered *)

let say quiet is_proved line =
  if not (quiet && is_proved) then Printf.printf "%s  %s\n" (if is_proved then "proved    " else "not proved") line

let say_left_out quiet what = if not quiet then Printf.printf "left out    %s\n" (String.concat ", " what)

(* Whether all is accepted; what is not is looked for without claims and decisions, and with each of them alone. *)
let judge ?(prefix = "") ?(is_known = false) quiet found =
  let c = found.certificate in
  let bare = { c with A.claims = []; A.decisions = [] } in
  let say is_proved line = say quiet is_proved (prefix ^ line) in
  let all = is_known || A.accept c in
  let frame = all || A.accept bare in
  say frame "the curve, its invariants, the rate, the rotation-minimizing frame on [0, 1]";
  let say_each alone = List.iter2 (fun line x -> say (all || frame && A.accept (alone x)) line) in
  say_each (fun x -> { bare with A.claims = [x] }) found.claims c.A.claims;
  say_each (fun x -> { bare with A.decisions = [x] }) found.decisions c.A.decisions;
  all

let judge_curve quiet found =
  let all = judge quiet found in
  say_left_out quiet found.left_out;
  all

(* The same of a path: without claims, and with each of them alone. *)
let judge_path quiet (segments, claims) =
  let accept claims =
    A.accept_path { A.segments = List.map (fun s -> s.certificate) segments;
      A.starts = List.map (fun s -> s.start) segments; A.path_claims = claims } in
  let all = accept (List.map snd claims) in
  let each k found = ignore (judge ~prefix:(Printf.sprintf "segment %d: " k) ~is_known:all quiet found) in
  List.iteri each segments;
  let joined = all || accept [] in
  say quiet joined "the segments, and that curve and frame go on from each to the next";
  List.iter (fun (line, x) -> say quiet (all || joined && accept [x]) line) claims;
  let add seen what = if List.mem what seen then seen else what :: seen in
  let of_segments = List.fold_left add [] (List.concat_map (fun s -> s.left_out) segments) in
  say_left_out quiet ("what is said of a closed path" :: List.rev of_segments);
  all

(* The certificate as a term of Coq. *)
let q (x : A.q) = Printf.sprintf "(%s) # %s" (Int.string_of_big_int x.A.qnum) (Int.string_of_big_int x.A.qden)
let list a = "[" ^ String.concat "; " a ^ "]"
let vector ((a, b), c) = Printf.sprintf "(%s, %s, %s)" (q a) (q b) (q c)
let claims_term claims =
  let claim (l : A.claim) = Printf.sprintf "Claim (%s) (%s) (%s)" (q l.A.time) (q l.A.angle) (q l.A.radius) in
  list (List.map claim claims)
let term (c : A.certificate) =
  let poly a = list (List.map q a) in
  let decision = function
    | A.Regular -> "Regular" | A.NoInflection -> "NoInflection" | A.NotLine -> "NotLine" | A.NotPlanar -> "NotPlanar"
    | A.NotHelical -> "NotHelical" | A.ErfIsRmf -> "ErfIsRmf" | A.ErfIsNotRmf -> "ErfIsNotRmf"
    | A.NotRegular l -> "NotRegular " ^ poly l
    | A.Inflection l -> "Inflection " ^ poly l
    | A.DoublePh (w, c) -> Printf.sprintf "DoublePh %s (%s)" (poly w) (q c)
    | A.Monotone -> "Monotone" | A.NotMonotone -> "NotMonotone"
    | A.Line l -> "Line " ^ vector l
    | A.Planar l -> "Planar " ^ vector l
    | A.Helical (l, c) -> Printf.sprintf "Helical %s (%s)" (vector l) (q c)
    | A.Rrmf (re, im) -> Printf.sprintf "Rrmf %s %s" (list (List.map q re)) (list (List.map q im)) in
  let bend = match c.A.bend with
    | None -> "None"
    | Some ((re, im), g) -> Printf.sprintf "(Some (%s, %s, %s))" (poly re) (poly im) (poly g) in
  let says what lines = Printf.sprintf "  (* %s *)\n  %s" what (String.concat "\n  " lines) in
  let parts = [
    says "u, v, p, q and f" (List.map poly [c.A.cu; c.A.cv; c.A.cp; c.A.cq; c.A.multiplier]);
    says "r', sigma, h, g" (List.map poly [c.A.cx'; c.A.cy'; c.A.cz'; c.A.csigma; c.A.ch; c.A.cg_re; c.A.cg_im]);
    says "numerator, denominator, common" (List.map poly [c.A.numerator; c.A.denominator; c.A.common]);
    says "Re gamma, Im gamma, G" [bend];
    says "a fraction" [Printf.sprintf "(%s, %s)" (poly (fst c.A.rational)) (poly (snd c.A.rational))];
    says "t, theta, radius" [claims_term c.A.claims];
    says "decisions" [list (List.map decision c.A.decisions)]] in
  "Certificate\n" ^ String.concat "\n" parts

(* The theorem that it is true. *)
let write_head more =
  Printf.printf "From Coq Require Import List ZArith QArith.\nRequire Import certificate_statement verified_checker%s.\n\
    Import ListNotations.\nOpen Scope Q_scope.\n\n" more

let write_theorem statement sound =
  Printf.printf "Theorem it_is_true : %s the_certificate.\n\
    Proof. apply %s; vm_compute; reflexivity. Qed.\n" statement sound

let write_coq found =
  write_head "";
  Printf.printf "Definition the_certificate := %s.\n\n" (term found.certificate);
  write_theorem "statement" "accept_sound"

let write_coq_of_path (segments, claims) =
  write_head " path_statement verified_path_checker";
  List.iteri (fun k s -> Printf.printf "Definition segment_%d := %s.\n\n" k (term s.certificate)) segments;
  let names = String.concat "; " (List.mapi (fun k _ -> Printf.sprintf "segment_%d" k) segments) in
  Printf.printf "Definition the_certificate := PathCertificate\n  [%s]\n  %s\n  %s.\n\n" names
    (list (List.map (fun s -> vector s.start) segments)) (claims_term (List.map snd claims));
  write_theorem "path_statement" "accept_path_sound"

let read name =
  let channel = if name = "-" then stdin else open_in_bin name in
  let data = Buffer.create 65536 in
  (try while true do Buffer.add_channel data channel 1 done with End_of_file -> ());
  if name <> "-" then close_in channel;
  Buffer.contents data

(* Exit status: 0 all is accepted, 1 something is not, 2 it cannot be read. *)
let check quiet to_coq name =
  let answer write judge found =
    if to_coq then (write found; 0) else begin
      let is_accepted = judge quiet found in
      print_endline (if is_accepted then "accepted but for what is left out" else "not accepted");
      if is_accepted then 0 else 1
    end in
  let any x = match find "phrame" "" x with
    | Text "path-certificate/1" -> answer write_coq_of_path judge_path (path_certificate x)
    | _ -> answer write_coq judge_curve (certificate "" x) in
  match any (parse (read name)) with
  | status -> status
  | exception Malformed what -> Printf.eprintf "check_certificate_verified: %s: %s\n" name what; 2
  | exception Sys_error what -> Printf.eprintf "check_certificate_verified: %s\n" what; 2

let () =
  let is_option s = String.length s > 1 && s.[0] = '-' in
  let options, files = List.partition is_option (List.tl (Array.to_list Sys.argv)) in
  if files = [] || List.exists (fun s -> s <> "-q" && s <> "--coq") options then begin
    prerr_endline "usage: check_certificate_verified [-q] [--coq] CERT...";
    exit 2
  end;
  let has s = List.mem s options in
  exit (List.fold_left (fun worst name -> max worst (check (has "-q") (has "--coq") name)) 0 files)
