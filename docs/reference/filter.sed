# What Doxygen sees of a header: as many lines as it has.

# Doxygen 1.9 takes phrame::inline v0 for a namespace beside phrame.
s/^namespace phrame::inline v0 /namespace phrame /

# What is defaulted without a comment says no more than its class does; raw() is for src/algebra.
/= default;( *\/\/ .*)?$/s/.*//
/[*] raw\(\)/s/.*//

# A formula on lines of its own, which the source indents by two blanks more, stays on such lines.
\,^ *///   +[^ ], {
  s,///  +,/// <br>\&emsp;,
  h
  b
}
x
/./ {
  s/.*//
  x
  s,/// ?,&<br>,
  b
}
x
