/* Reading dates (POSIX strptime) in the "C" locale. */
#include <ctype.h>
#include <string.h>
#include <time.h>

static const char *const days[] = {
    "Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday",
};
static const char *const months[] = {
    "January", "February", "March", "April", "May", "June", "July", "August", "September",
    "October", "November", "December",
};
static const char *const halves[] = {"AM", "PM"};

/* What has been read, beside the date itself. */
struct reading {
    struct tm *date;
    int century, half, has_year, has_month, has_day, has_yday, has_wday;
};

/* Reads a number of at most some digits; returns the place behind it, null if it is out of
   range. */
static const char *number(const char *at, int most_digits, int least, int most, int *value)
{
    int digits = 0;

    while (isspace((unsigned char)*at))
        at++;
    for (*value = 0; digits < most_digits && isdigit((unsigned char)*at); digits++) {
        if (digits > 0 && *value * 10 > most)
            break;
        *value = *value * 10 + *at++ - '0';
    }
    return digits > 0 && least <= *value && *value <= most ? at : NULL;
}

static int differ(const char *left, const char *right, int size)
{
    for (; size > 0; size--)
        if (tolower((unsigned char)*left++) != tolower((unsigned char)*right++))
            return 1;
    return 0;
}

/* Reads one of some names, or its first letters; returns the place behind it. */
static const char *name(const char *at, const char *const *names, int count, int letters,
                        int *value)
{
    int i, size;

    for (i = 0; i < count; i++) {
        size = strlen(names[i]);
        if (differ(at, names[i], size) != 0)
            size = letters;
        if (size > 0 && differ(at, names[i], size) == 0) {
            *value = i;
            return at + size;
        }
    }
    return NULL;
}

static const char *read_format(const char *at, const char *format, struct reading *reading);

static const char *read_zone(const char *at, struct tm *date)
{
    int sign = *at == '-' ? -1 : 1, hours, minutes = 0;

    if (*at == 'Z') {
        date->tm_gmtoff = 0;
        return at + 1;
    }
    if (*at != '+' && *at != '-')
        return NULL;
    at = number(at + 1, 2, 0, 23, &hours);
    if (at == NULL)
        return NULL;
    at += *at == ':';
    if (isdigit((unsigned char)*at) && (at = number(at, 2, 0, 59, &minutes)) == NULL)
        return NULL;
    date->tm_gmtoff = sign * (hours * 3600 + minutes * 60);
    return at;
}

static const char *read_seconds(const char *at, struct reading *reading)
{
    time_t time = 0;

    if (!isdigit((unsigned char)*at))
        return NULL;
    while (isdigit((unsigned char)*at))
        time = time * 10 + *at++ - '0';
    *reading->date = *localtime(&time);
    return at;
}

/* Reads the year's conversions. */
static const char *read_year(const char *at, int letter, struct reading *reading)
{
    int value;

    at = number(at, letter == 'Y' ? 4 : 2, 0, 9999, &value);
    if (letter == 'C') {
        reading->century = value;
        reading->has_year += reading->has_year == 0;
        return at;
    }
    if (letter == 'y')
        value = value < 69 ? value + 100 : value;
    reading->date->tm_year = letter == 'Y' ? value - 1900 : value;
    reading->has_year = letter == 'y' ? 2 : 1;   /* 2: of a century */
    if (letter == 'Y')
        reading->century = -1;
    return at;
}

static const char *read_conversion(const char *at, int letter, struct reading *reading)
{
    struct tm *date = reading->date;
    int value;

    switch (letter) {
    case '%': return *at == '%' ? at + 1 : NULL;
    case 'n': case 't':
        while (isspace((unsigned char)*at))
            at++;
        return at;
    case 'a': case 'A':
        reading->has_wday = 1;
        return name(at, days, 7, 3, &date->tm_wday);
    case 'b': case 'B': case 'h':
        reading->has_month = 1;
        return name(at, months, 12, 3, &date->tm_mon);
    case 'd': case 'e':
        reading->has_day = 1;
        return number(at, 2, 1, 31, &date->tm_mday);
    case 'm':
        reading->has_month = 1;
        at = number(at, 2, 1, 12, &value);
        date->tm_mon = value - 1;
        return at;
    case 'H': case 'k':
        reading->half = -1;
        return number(at, 2, 0, 23, &date->tm_hour);
    case 'I': case 'l':
        at = number(at, 2, 1, 12, &value);
        date->tm_hour = value % 12;
        return at;
    case 'M': return number(at, 2, 0, 59, &date->tm_min);
    case 'S': return number(at, 2, 0, 61, &date->tm_sec);
    case 'p':
        return name(at, halves, 2, 0, &reading->half);
    case 'j':
        reading->has_yday = 1;
        at = number(at, 3, 1, 366, &value);
        date->tm_yday = value - 1;
        return at;
    case 'u':
        reading->has_wday = 1;
        at = number(at, 1, 1, 7, &value);
        date->tm_wday = value % 7;
        return at;
    case 'w':
        reading->has_wday = 1;
        return number(at, 1, 0, 6, &date->tm_wday);
    case 'U': case 'W': case 'V': return number(at, 2, 0, 53, &value);
    case 'g': return number(at, 2, 0, 99, &value);
    case 'G': return number(at, 4, 0, 9999, &value);
    case 'C': case 'y': case 'Y': return read_year(at, letter, reading);
    case 's': return read_seconds(at, reading);
    case 'z': return read_zone(at, date);
    case 'Z': return strncmp(at, "UTC", 3) == 0 || strncmp(at, "GMT", 3) == 0 ? at + 3 : NULL;
    case 'c': return read_format(at, "%a %b %e %H:%M:%S %Y", reading);
    case 'D': case 'x': return read_format(at, "%m/%d/%y", reading);
    case 'F': return read_format(at, "%Y-%m-%d", reading);
    case 'R': return read_format(at, "%H:%M", reading);
    case 'T': case 'X': return read_format(at, "%H:%M:%S", reading);
    case 'r': return read_format(at, "%I:%M:%S %p", reading);
    }
    return NULL;
}

static const char *read_format(const char *at, const char *format, struct reading *reading)
{
    for (; *format && at != NULL; format++) {
        if (isspace((unsigned char)*format)) {
            while (isspace((unsigned char)*at))
                at++;
        } else if (*format != '%') {
            at = *at == *format ? at + 1 : NULL;
        } else {
            format++;
            format += *format == 'E' || *format == 'O';
            at = *format ? read_conversion(at, *format, reading) : NULL;
            if (*format == 0)
                break;
        }
    }
    return at;
}

static int is_leap(int year)
{
    return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

/* Returns the number of days before a month of a year. */
static int days_before(int month, int year)
{
    static const short before[] = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334, 365};

    return before[month] + (month > 1 && is_leap(year));
}

/* Derives what a date determines, as glibc does: the days of week and year, and the day of
   the month from that of the year. */
static void complete(struct reading *reading)
{
    struct tm *date = reading->date;
    int year, past;

    if (reading->half == 1)
        date->tm_hour += 12;
    if (reading->century >= 0)
        date->tm_year = reading->century * 100 - 1900 +
                        (reading->has_year == 2 ? date->tm_year % 100 : 0);
    if (!reading->has_month && !reading->has_day && !reading->has_year)
        return;
    year = date->tm_year + 1900;
    if (reading->has_yday && !(reading->has_month && reading->has_day)) {
        for (date->tm_mon = 0; date->tm_mon < 11; date->tm_mon++)
            if (days_before(date->tm_mon + 1, year) > date->tm_yday)
                break;
        date->tm_mday = date->tm_yday - days_before(date->tm_mon, year) + 1;
    }
    past = days_before(date->tm_mon, year) + date->tm_mday - 1;
    if (!reading->has_yday)
        date->tm_yday = past;
    year--;
    if (!reading->has_wday)    /* 1 January of the year 1 was a Monday */
        date->tm_wday = ((1 + 365 * year + year / 4 - year / 100 + year / 400 + past) % 7 + 7) % 7;
}

char *strptime(const char *text, const char *format, struct tm *date)
{
    struct reading reading = {date, -1, -1, 0, 0, 0, 0, 0};
    const char *end = read_format(text, format, &reading);

    if (end != NULL)
        complete(&reading);
    return (char *)end;
}
