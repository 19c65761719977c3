# Loaded before each figure: colours that differ for every eye (Okabe and Ito 2008), and with each its own point.
reset
set encoding utf8
set linetype 1 lc rgb "#0072B2" lw 1.6 pt 7 ps 0.55
set linetype 2 lc rgb "#D55E00" lw 1.6 pt 5 ps 0.50
set linetype 3 lc rgb "#009E73" lw 1.6 pt 9 ps 0.70
set linetype 4 lc rgb "#CC79A7" lw 1.6 pt 11 ps 0.70
set linetype 5 lc rgb "#E69F00" lw 1.6 pt 13 ps 0.75
set linetype 6 lc rgb "#56B4E9" lw 1.6 pt 6 ps 0.60
set linetype 7 lc rgb "#000000" lw 1.6 pt 4 ps 0.55
set linetype 8 lc rgb "#0072B2" lw 1.6 pt 8 ps 0.70
set linetype 9 lc rgb "#D55E00" lw 1.6 pt 10 ps 0.70
set linetype 10 lc rgb "#009E73" lw 1.6 pt 12 ps 0.75
set linetype 11 lc rgb "#CC79A7" lw 1.6 pt 1 ps 0.60
set linetype 12 lc rgb "#E69F00" lw 1.6 pt 2 ps 0.60
set linetype cycle 12
set border 3 lc rgb "#333333" lw 0.8
set tics out nomirror textcolor rgb "#111111"
set grid xtics ytics lc rgb "#dddddd" lw 0.6 lt 1
set bars 0.6
set style textbox opaque noborder fillcolor rgb "#ffffff" margins 0.3,0.2
set key bmargin center vertical Left reverse samplen 2.5 spacing 1.05
set lmargin 11
set rmargin 4
set tmargin 1.6
# A slope may end on the limits at both ends, and by a rounding beyond them.
set clip two
