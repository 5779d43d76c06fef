/* Shared parts of the mathematical functions: access to bits, arithmetic with twice the digits,
   errors, and the kernels that several of them are built on. */
#ifndef CRS_KERNEL_H
#define CRS_KERNEL_H

union __crs_bits {
    double value;
    unsigned long long bits;
};

#define SIGN_BIT 0x8000000000000000ULL
#define FRACTION_BITS 0x000fffffffffffffULL
#define EXPONENT_OF(bits) ((int)((bits) >> 52 & 0x7ff))   /* biased by 1023 */

/* A number as the unevaluated sum of two doubles, |lo| at most half a unit of hi's last place. */
struct __crs_pair {
    double hi, lo;
};

/* (hi + lo) * 2^exponent. */
struct __crs_scaled {
    double hi, lo;
    int exponent;
};

/* sum + error is exactly a + b (Knuth, TAOCP 4.2.2); the first form needs |a| >= |b| or a = 0
   (Dekker, "A floating-point technique for extending the available precision", 1971). */
#define FAST_TWO_SUM(sum, error, a, b)  \
    do {                                \
        double a_ = (a), b_ = (b);      \
        sum = a_ + b_;                  \
        error = b_ - (sum - a_);        \
    } while (0)

#define TWO_SUM(sum, error, a, b)                         \
    do {                                                  \
        double a_ = (a), b_ = (b), part_;                 \
        sum = a_ + b_;                                    \
        part_ = sum - a_;                                 \
        error = (a_ - (sum - part_)) + (b_ - part_);      \
    } while (0)

/* product + error is exactly a * b, by Veltkamp's splitting (Dekker, 1971); |a|, |b| < 2^990. */
#define TWO_PRODUCT(product, error, a, b)                                           \
    do {                                                                            \
        double a_ = (a), b_ = (b), c_ = a_ * 134217729.0, d_ = b_ * 134217729.0;    \
        double ah_ = c_ - (c_ - a_), bh_ = d_ - (d_ - b_);                          \
        double al_ = a_ - ah_, bl_ = b_ - bh_;                                      \
        product = a_ * b_;                                                          \
        error = ((ah_ * bh_ - product) + ah_ * bl_ + al_ * bh_) + al_ * bl_;        \
    } while (0)

/* Errors (C17 7.12.1): each sets errno and returns the function's value. */
double __crs_domain_error(void);              /* not a number, EDOM */
double __crs_pole_error(double sign);         /* infinity, ERANGE */
double __crs_overflow(double sign);           /* infinity, ERANGE */
double __crs_underflow(double sign);          /* zero, ERANGE */

/* value * 2^exponent for 1/4 <= |value| <= 4 and an exponent from -1100 to 1024, rounded once. */
double __crs_scale(double value, int exponent);

/* The same for all values and exponents, with overflow and underflow. */
double __crs_ldexp(double value, int exponent);

/* exp(hi + lo), the sum between -760 and 760, to about 2^-60. */
struct __crs_scaled __crs_exp_pair(double hi, double lo);

/* The same rounded to a double, with overflow and underflow. */
double __crs_exp(double hi, double lo);

/* log(hi + lo) for a positive finite hi + lo, and log(1 + x) for a finite x > -1, to 2^-66. */
struct __crs_pair __crs_log_pair(double hi, double lo);
struct __crs_pair __crs_log1p_pair(double x);

/* x = n pi/2 + (hi + lo), |hi| <= pi/4, for finite x; returns n modulo 4. */
int __crs_reduce(double x, struct __crs_pair *rest);

/* Sine and cosine of hi + lo, |hi| <= pi/4; the sum of the result's parts has about 2^-58. */
struct __crs_pair __crs_sin_kernel(double hi, double lo);
struct __crs_pair __crs_cos_kernel(double hi, double lo);

/* The angle of the point (x, y), from -pi to pi; x and y finite, not both zero. */
double __crs_angle(double y, double x);

/* c[0] + c[1] x + ... + c[count - 1] x^(count - 1). */
double __crs_polynomial(const double *c, int count, double x);

/* log |gamma(x)|, and the sign of gamma(x). */
double __crs_log_gamma(double x, int *sign);

#endif
