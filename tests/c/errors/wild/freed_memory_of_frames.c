/* Deep below the stack. */
static int sum;

int main(void)
{
    int here = 1, *volatile p = &here;

    p -= 50000;
    sum = *p; // error: wild pointer
    return sum;
}
