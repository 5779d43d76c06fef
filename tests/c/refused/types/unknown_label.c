/* goto to a label that is not there. */
int main(void)
{
    goto nowhere; // error: label
    return 0;
}
