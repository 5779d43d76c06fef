/* A variable of a loop's body has no value at the start of each turn. */
int main(void)
{
    int i, sum = 0;

    for (i = 0; i < 3; i++) {
        int parts[2], *p = parts;
        if (i == 0)
            p[1] = 5;
        sum += p[1]; // error: uninitialised read
    }
    return sum;
}
