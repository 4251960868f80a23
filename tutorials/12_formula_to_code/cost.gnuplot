# Number of nodes of the intermediate form after each stage: about ninety after lowering, a third of it once common subexpressions are shared, nearly the same after the later passes, and fewer again when only one output is wanted.
set style data histogram
set style fill solid 0.8
set boxwidth 0.7
set yrange [0:*]
set ylabel 'nodes'
set xtics rotate by -20
set key off
set grid y
plot '{{stages}}' using 2:xtic(1) linecolor rgb '#1f4e8c'
