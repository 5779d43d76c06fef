/* The exact decimal value of a double. */
#ifndef CRS_DECIMAL_H
#define CRS_DECIMAL_H

/* The number 0.ddd... * 10^point, where the d are the first `count` characters of `digits`;
   all digits after them are 0. No double has more than 767 significant digits; room is for those
   and the unfinished block of nine that rounding looks at. */
struct __crs_decimal {
    int count;
    int point;
    char digits[800];
};

/* Returns |x| rounded to `precision` digits after the decimal point, ties to even. */
void __crs_round_fixed(struct __crs_decimal *decimal, double x, int precision);

/* Returns |x| rounded to `precision` significant digits, ties to even. */
void __crs_round_significant(struct __crs_decimal *decimal, double x, int precision);

#endif
