/* Dates (C17 7.27.2.3, 7.27.3). Local time is UTC. Days are counted in years that begin in March,
   whose leap day is the last, in eras of 400 years (146097 days) from 1 March of year 0 on. */
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#define DAY_S 86400
#define ERA_DAYS 146097
#define EPOCH_DAYS 719468   /* from 1 March of year 0 to 1 January 1970 */

char *tzname[2] = {"UTC", "UTC"};
long timezone;
int daylight;

void tzset(void)
{
}

static long long floor_divide(long long value, long long by)
{
    return value / by - (value % by < 0);
}

/* Returns the days from 1 January 1970 to a day of a month, 0 to 11, of a year. */
static long long days_to(long long year, int month, long long day)
{
    int from_march = (month + 10) % 12;
    long long era, year_of_era;

    year -= month < 2;
    era = floor_divide(year, 400);
    year_of_era = year - era * 400;
    return era * ERA_DAYS + year_of_era * 365 + year_of_era / 4 - year_of_era / 100 +
           (153 * from_march + 2) / 5 + day - 1 - EPOCH_DAYS;
}

static struct tm *take_apart(long long time, struct tm *date)
{
    long long days = floor_divide(time, DAY_S), era, year;
    int second = time - days * DAY_S, day_of_era, year_of_era, day_of_year, from_march;

    era = floor_divide(days + EPOCH_DAYS, ERA_DAYS);
    day_of_era = days + EPOCH_DAYS - era * ERA_DAYS;
    year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36524 - day_of_era / 146096) / 365;
    day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    from_march = (5 * day_of_year + 2) / 153;
    year = era * 400 + year_of_era + (from_march >= 10);
    if (year - 1900 > INT_MAX || year - 1900 < INT_MIN) {
        errno = EOVERFLOW;
        return NULL;
    }
    date->tm_sec = second % 60;
    date->tm_min = second / 60 % 60;
    date->tm_hour = second / 3600;
    date->tm_mday = day_of_year - (153 * from_march + 2) / 5 + 1;
    date->tm_mon = (from_march + 2) % 12;
    date->tm_year = year - 1900;
    date->tm_wday = days + 4 - 7 * floor_divide(days + 4, 7);
    date->tm_yday = days - days_to(year, 0, 1);
    date->tm_isdst = 0;
    date->tm_gmtoff = 0;
    date->tm_zone = "UTC";
    return date;
}

/* Normalises the members; returns -1 if the time cannot be represented (C17 7.27.2.3). */
static time_t put_together(struct tm *date)
{
    long long months = date->tm_year * 12LL + date->tm_mon;
    long long year = floor_divide(months, 12);
    long long time = days_to(year + 1900, months - year * 12, date->tm_mday) * DAY_S;

    time += date->tm_hour * 3600LL + date->tm_min * 60LL + date->tm_sec;
    if (time > LONG_MAX || time < LONG_MIN || take_apart(time, date) == NULL) {
        errno = EOVERFLOW;
        return -1;
    }
    return time;
}

time_t mktime(struct tm *date)
{
    return put_together(date);
}

time_t timegm(struct tm *date)
{
    return put_together(date);
}

struct tm *gmtime_r(const time_t *time, struct tm *date)
{
    return take_apart(*time, date);
}

struct tm *localtime_r(const time_t *time, struct tm *date)
{
    return take_apart(*time, date);
}

/* One object for both, as C17 7.27.3 allows and Linux has it. */
static struct tm shared;

struct tm *gmtime(const time_t *time)
{
    return take_apart(*time, &shared);
}

struct tm *localtime(const time_t *time)
{
    return take_apart(*time, &shared);
}

/* Writes the 26 characters of C17 7.27.3.1; a date that needs more returns null. */
static char *write_date(const struct tm *date, char *text)
{
    static const char days[] = "SunMonTueWedThuFriSat";
    static const char months[] = "JanFebMarAprMayJunJulAugSepOctNovDec";
    const char *day = date->tm_wday >= 0 && date->tm_wday < 7 ? days + date->tm_wday * 3 : "???";
    const char *month =
        date->tm_mon >= 0 && date->tm_mon < 12 ? months + date->tm_mon * 3 : "???";
    char whole[100];
    int size = sprintf(whole, "%.3s %.3s%3d %.2d:%.2d:%.2d %lld\n", day, month, date->tm_mday,
                       date->tm_hour, date->tm_min, date->tm_sec, 1900LL + date->tm_year);

    if (size < 26)
        return strcpy(text, whole);
    errno = EOVERFLOW;
    return NULL;
}

static char shared_text[26];

char *asctime_r(const struct tm *date, char *text)
{
    return write_date(date, text);
}

char *asctime(const struct tm *date)
{
    return write_date(date, shared_text);
}

char *ctime_r(const time_t *time, char *text)
{
    struct tm date;

    return take_apart(*time, &date) == NULL ? NULL : write_date(&date, text);
}

char *ctime(const time_t *time)
{
    return take_apart(*time, &shared) == NULL ? NULL : write_date(&shared, shared_text);
}
